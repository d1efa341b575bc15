#include "core/mapping/relocalisation/relocaliser.h"

#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/mapping/relocalisation/place_recognition.h"
#include "tests/core/mapping/live/mapped_room.h"

namespace leitstand::test {
namespace {

using testing::Ge;
using testing::IsEmpty;
using testing::SizeIs;

const Pose First = poseFrom({-1.6, 0.3, 0.9}, 0, 0, 0);

/// The furnished room, mapped from five places along it.
LiveMap mappedRoom() {
    MappedRoom room;
    for (int i = 0; i < 5; ++i)
        (void)room.add(First * poseFrom({0.5 * i, 0.1 * i, 0}, 0, 0, degrees(4.0 * i)));
    return *room.mapper.map();
}

/// A scan that nobody knows the place of.
struct Drop {
    explicit Drop(const Pose& sensorInRoom, unsigned seed = 77)
        : live(scanAt(sensorInRoom, seed)), ready(readyScan(live, {}, Pose::Identity(), {})) {}
    [[nodiscard]] Relocalisation in(const Relocaliser& relocaliser) const {
        return relocaliser.find(*ready.scan, ready.reduced, live.up);
    }
    LiveScan live;
    ReadyScan ready;
};

std::string textOf(const Relocalisation& found) {
    std::string text = std::to_string(found.places.size()) + " of " + std::to_string(found.tried) + " fit";
    for (const AlikePlace& place : found.places) {
        text += "; overlap " + std::to_string(place.overlap) + ", rms " + std::to_string(place.rms) +
                ", filled " + std::to_string(place.filled) + ", score " + std::to_string(place.score);
    }
    return text;
}

void expectAt(const Pose& found, const Pose& sensorInRoom) {
    const Pose expected = First.inverse() * sensorInRoom;
    EXPECT_LT(distanceBetween(found, expected), 0.03);
    EXPECT_LT(inDegrees(angleBetween(found, expected)), 0.5);
}

TEST(Relocaliser, FindsAScanWhereverAndHoweverTheRobotStands) {
    const Relocaliser relocaliser(std::make_shared<const LiveMap>(mappedRoom()), {});
    int sure = 0;
    for (const Pose& there : {poseFrom({0.6, -1.2, 0.9}, 0, 0, degrees(135)),
                              poseFrom({-2.4, 1.1, 0.9}, degrees(3), degrees(-4), degrees(-80)),
                              poseFrom({1.9, 0.9, 0.9}, 0, 0, degrees(178))}) {
        const Relocalisation found = Drop(there).in(relocaliser);
        ASSERT_FALSE(found.places.empty()) << found.tried;
        expectAt(found.places.front().scanInMap, there);
        EXPECT_GT(found.places.front().overlap, 0.7);
        sure += found.sure ? 1 : 0;
        std::printf("relocalisation: %s\n", textOf(found).c_str());
    }
    EXPECT_GE(sure, 1) << "the room looks nearly the same when it is turned by 180 degrees";
}

TEST(Relocaliser, IsNotSureWhereTwoPlacesLookAlike) {
    LiveMap map = mappedRoom();
    const std::size_t scans = map.scans.size();
    const Pose twin = poseFrom({20.0, 3.0, 0.0}, 0, 0, degrees(90));
    for (std::size_t i = 0; i < scans; ++i) {
        LiveKeyScan copy = map.scans[i];
        copy.id += 100;
        copy.pose.scan = copy.id;
        copy.pose.scanInMap = twin * copy.pose.scanInMap;
        map.scans.push_back(copy);
    }
    const Pose there = poseFrom({0.2, -0.9, 0.9}, 0, 0, degrees(-30));
    const Relocalisation found =
        Drop(there).in(Relocaliser(std::make_shared<const LiveMap>(map), {}, forLostRobots()));
    EXPECT_FALSE(found.sure);
    ASSERT_THAT(found.places, SizeIs(Ge(2U)));
    const bool firstIsHere = found.places[0].scanInMap.translation().norm() < 8.0;
    expectAt(found.places[firstIsHere ? 0 : 1].scanInMap, there);
    expectAt(twin.inverse() * found.places[firstIsHere ? 1 : 0].scanInMap, there);
}

/// A scan of a corridor with an end at x = 6 and none that is seen the other way.
LiveScan corridorScan(double x, unsigned seed) {
    RoomSettings corridor;
    corridor.length = 40.0;
    corridor.width = 2.2;
    corridor.furnished = false;
    corridor.sweep = Sweep::Yawing;
    corridor.rows = 181;
    corridor.columns = 81;
    corridor.seed = seed;
    corridor.sensorInRoom = poseFrom({x + 14.0, 0, 0.9}, 0, 0, 0);
    Scan scan = scanRoom(corridor).scan;
    scan.robot = "kurt3d";
    scan.end = Time(std::chrono::seconds(1000 + seed));
    LiveScan live;
    live.levelKnown = true;
    live.scan = std::make_shared<const Scan>(std::move(scan));
    return live;
}

TEST(Relocaliser, IsNotSureAlongABareCorridor) {
    MappedRoom corridor;
    unsigned seed = 0;
    for (double x = -12.0; x < 5.0; x += 0.8) (void)corridor.add(corridorScan(x, ++seed));
    const Relocaliser relocaliser(corridor.mapper.map(), {}, forLostRobots());
    const auto sought = [&](double x) {
        const LiveScan live = corridorScan(x, 77);
        const ReadyScan ready = readyScan(live, {}, Pose::Identity(), {});
        return relocaliser.find(*ready.scan, ready.reduced, live.up);
    };
    const Relocalisation middle = sought(-2.6);  // its end, far away, holds the scan weakly
    EXPECT_FALSE(middle.sure) << "from above any place along it looks like that";
    ASSERT_FALSE(middle.places.empty());
    EXPECT_GT(middle.places.front().beside, 0.97 * middle.places.front().score);
    const Relocalisation end = sought(4.1);
    ASSERT_FALSE(end.places.empty());
    EXPECT_LT(end.places.front().beside, 0.95 * end.places.front().score) << "its end holds a scan";
}

TEST(Relocaliser, FindsNothingInAnotherRoomOrInNone) {
    const Relocaliser relocaliser(std::make_shared<const LiveMap>(mappedRoom()), {});
    RoomSettings other;
    other.length = 5.0;
    other.width = 11.0;
    other.furnished = false;
    other.sweep = Sweep::Yawing;
    other.rows = 121;
    other.columns = 81;
    LiveScan live;
    live.scan = std::make_shared<const Scan>(scanRoom(other).scan);
    const ReadyScan ready = readyScan(live, {}, Pose::Identity(), {});
    EXPECT_FALSE(relocaliser.find(*ready.scan, ready.reduced, live.up).sure);
    const Relocaliser nowhere(std::make_shared<const LiveMap>(), {});
    EXPECT_THAT(Drop(First).in(nowhere).places, IsEmpty());
}

TEST(Relocaliser, OfScansThatAreSetAsideOrUncertainNothingIsBuiltOn) {
    LiveMap map = mappedRoom();
    for (LiveKeyScan& scan : map.scans) scan.pose.trust = ScanTrust::Uncertain;
    EXPECT_THAT(Drop(First).in(Relocaliser(std::make_shared<const LiveMap>(map), {})).places, IsEmpty());
}

/// The room, mapped, and a scan that came in later, 6 m and 40 degrees from where it was taken.
SoughtPlace soughtIn(const LiveMap& room, const Pose& sensorInRoom) {
    const Drop drop(sensorInRoom);
    const auto map = std::make_shared<LiveMap>(room);
    LiveKeyScan scan;
    scan.id = 50;
    scan.scan = drop.ready.scan;
    scan.up = drop.live.up;
    scan.pose.trust = ScanTrust::Certain;
    scan.pose.scanInMap = poseFrom({5.0, -3.5, 0}, 0, 0, degrees(40)) * First.inverse() * sensorInRoom;
    scan.reduced = MatchedClouds(nullptr, 4).keep(drop.ready.reduced, [] { return PointCloud(); });
    map->scans.push_back(scan);
    return {scan.id, map, {{scan.id, 0.0}}};
}

TEST(PlaceRecognition, FindsWhereAScanWasTakenInTheMapsEarlierPart) {
    const LiveMap room = mappedRoom();
    int found = 0;
    for (const Pose& there : {poseFrom({0.6, -1.2, 0.9}, 0, 0, degrees(135)),
                              poseFrom({-2.4, 1.1, 0.9}, degrees(3), degrees(-4), degrees(-80)),
                              poseFrom({1.9, 0.9, 0.9}, 0, 0, degrees(178))}) {
        const auto pose = recognise(soughtIn(room, there), {});
        if (!pose) continue;
        ++found;
        expectAt(*pose, there);
    }
    EXPECT_GE(found, 1);
}

TEST(PlaceRecognition, NothingOfLatelyIsTakenForAnEarlierPart) {
    SoughtPlace sought = soughtIn(mappedRoom(), poseFrom({0.6, -1.2, 0.9}, 0, 0, degrees(135)));
    for (const LiveKeyScan& scan : sought.map->scans) sought.lately.emplace(scan.id, 1.0);
    EXPECT_FALSE(recognise(sought, {}));
    sought.scan = 99;
    EXPECT_FALSE(recognise(sought, {})) << "there is no such scan";
}

TEST(PlaceRecognition, WhatWasSeenLatelyMustNotStandWhereTheEarlierPartLookedThrough) {
    LiveMap room = mappedRoom();
    for (const Pose& there : {poseFrom({0.6, -1.2, 0.9}, 0, 0, degrees(135)),
                              poseFrom({-2.4, 1.1, 0.9}, degrees(3), degrees(-4), degrees(-80)),
                              poseFrom({1.9, 0.9, 0.9}, 0, 0, degrees(178))}) {
        SoughtPlace sought = soughtIn(room, there);
        if (!recognise(sought, {})) continue;
        // Lately the robot was in a narrow place, which would stand within the room.
        RoomSettings narrow;
        narrow.length = 2.0;
        narrow.width = 1.5;
        narrow.furnished = false;
        auto map = std::make_shared<LiveMap>(*sought.map);
        for (int i = 0; i < 4; ++i) {
            LiveKeyScan other = map->scans.back();
            other.id = 60 + static_cast<std::uint64_t>(i);
            other.scan = std::make_shared<const Scan>(scanRoom(narrow).scan);
            sought.lately.emplace(other.id, 1.0);
            map->scans.push_back(other);
        }
        sought.map = map;
        EXPECT_FALSE(recognise(sought, {}));
        return;
    }
    FAIL() << "no place was recognised";
}

std::vector<Eigen::Vector2f> corner() {
    std::vector<Eigen::Vector2f> walls;
    for (float along = 0.0F; along < 6.0F; along += 0.1F) walls.emplace_back(along, 0.0F);
    for (float along = 0.0F; along < 3.0F; along += 0.1F) walls.emplace_back(0.0F, along);
    for (float along = 0.0F; along < 1.5F; along += 0.1F) walls.emplace_back(4.0F + along, 2.0F);
    return walls;
}

TEST(WallRaster, FindsWhereWallsWereSeenFromWithinACell) {
    const WallRaster raster(corner());
    const FlatPose there{{1.3, 1.7}, degrees(100)};
    std::vector<Eigen::Vector2f> view;
    for (const Eigen::Vector2f& wall : corner()) {
        view.emplace_back(
            (Eigen::Rotation2Dd(-there.heading) * (wall.cast<double>() - there.place)).cast<float>());
    }
    const auto found = raster.find(view).places;
    ASSERT_FALSE(found.empty());
    EXPECT_LT((found[0].pose.place - there.place).norm(), 0.12);
    EXPECT_LT(std::abs(std::remainder(found[0].pose.heading - there.heading, 2 * M_PI)), degrees(2));
    EXPECT_GT(found[0].score, 0.7);
    for (std::size_t i = 1; i < found.size(); ++i) EXPECT_LE(found[i].score, found[i - 1].score + 1e-6);
}

TEST(WallRaster, FindsAllPlacesThatLookAlike) {
    std::vector<Eigen::Vector2f> walls = corner();
    for (const Eigen::Vector2f& wall : corner()) walls.emplace_back(wall + Eigen::Vector2f(30.0F, 12.0F));
    const WallRaster raster(walls);
    std::vector<Eigen::Vector2f> view;
    for (const Eigen::Vector2f& wall : corner()) view.emplace_back(wall - Eigen::Vector2f(2.0F, 1.0F));
    const auto found = raster.find(view).places;
    ASSERT_GE(found.size(), 2U);
    EXPECT_NEAR(found[0].score, found[1].score, 0.05);
    EXPECT_NEAR((found[0].pose.place - found[1].pose.place).norm(), std::hypot(30.0, 12.0), 0.3);
    for (std::size_t i = 1; i < found.size(); ++i)
        EXPECT_GE(found[i].score, RasterSearch{}.likeBest * found[0].score - 1e-6) << "the others do not";
}

TEST(WallRaster, TellsWhatItDidNotLookAt) {
    std::vector<Eigen::Vector2f> walls;
    for (int i = 0; i < 6; ++i) {
        for (const Eigen::Vector2f& wall : corner())
            walls.emplace_back(wall + Eigen::Vector2f(12.0F * static_cast<float>(i), 0.0F));
    }
    std::vector<Eigen::Vector2f> view;
    for (const Eigen::Vector2f& wall : corner()) view.emplace_back(wall - Eigen::Vector2f(2.0F, 1.0F));
    RasterSearch search;
    search.most = 2;
    const RasterPlaces some = WallRaster(walls).find(view, search);
    ASSERT_THAT(some.places, SizeIs(2));
    EXPECT_GT(some.others, 0.9 * some.places.front().score) << "four more look as well";
    EXPECT_LT(WallRaster(corner()).find(view, search).others, 0.9);
}

TEST(WallRaster, OfAMapTooLargeThereIsNothing) {
    const std::vector<Eigen::Vector2f> far = {{-490.0F, -490.0F}, {490.0F, 490.0F}};
    const std::vector<Eigen::Vector2f> view = {{1.0F, 0.0F}, {0.0F, 1.0F}};
    EXPECT_THAT(WallRaster(far).find(view).places, IsEmpty());
}

TEST(Relocaliser, IsCancelledWithNothingFound) {
    std::stop_source stop;
    stop.request_stop();
    const Progress progress{{}, stop.get_token()};
    const Drop drop(First);
    const Relocaliser relocaliser(std::make_shared<const LiveMap>(mappedRoom()), {}, {}, progress);
    EXPECT_THAT(relocaliser.find(*drop.ready.scan, drop.ready.reduced, drop.live.up, progress).places,
                IsEmpty());
}

TEST(WallRaster, OfNothingAndOfNonsenseThereIsNothing) {
    constexpr float NaN = std::numeric_limits<float>::quiet_NaN();
    const std::vector<Eigen::Vector2f> none, broken = {{NaN, 0.0F}, {1e30F, 1.0F}};
    const std::vector<Eigen::Vector2f> view = {{1.0F, 0.0F}};
    EXPECT_THAT(WallRaster(none).find(view).places, IsEmpty());
    EXPECT_THAT(WallRaster(broken).find(view).places, IsEmpty());
    EXPECT_THAT(WallRaster(corner()).find(none).places, IsEmpty());
}

}  // namespace
}  // namespace leitstand::test
