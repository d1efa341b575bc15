// Loops where rooms look alike.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/core/mapping/live/mapped_room.h"
#include "tests/core/mapping/placement/box_scene.h"

namespace leitstand::test {
namespace {

LiveSettings closing(double nearTurn) {
    LiveSettings settings;
    settings.loops.nearTurn = nearTurn;
    settings.loops.drift = settings.loops.openDrift = 0.1;  // as if the way were long
    settings.loops.sameAge = 2.0;
    settings.loops.about = 1.5;
    settings.loops.reach = 1.5;
    settings.loops.apart = 0.3;
    settings.loops.seekEvery = 0.0;
    return settings;
}

/// A square room without furniture, which looks the same from each of its four sides.
LiveScan squareScanAt(const Pose& sensorInRoom, unsigned seed) {
    LiveScan live = scanAt(sensorInRoom, seed);
    RoomSettings room;
    room.sensorInRoom = sensorInRoom;
    room.sweep = Sweep::Yawing;
    room.rows = 121;
    room.columns = 81;
    room.seed = seed;
    room.length = room.width = 6.0;
    room.furnished = false;
    Scan scan = *live.scan;
    scan.points = scanRoom(room).scan.points;
    live.scan = std::make_shared<const Scan>(std::move(scan));
    return live;
}

/// How many loops close by themselves that put a scan before another wall of the square room than it was
/// taken at, where the map's newer half is turned by 50 degrees.
int wrongLoops(double nearTurn) {
    MappedRoom room(closing(nearTurn));
    const auto placeAt = [](std::uint64_t scan) {
        const double angle = 0.25 * static_cast<double>(scan - 1);
        return poseFrom({-1.2 * std::cos(angle), -1.2 * std::sin(angle), 0.9}, 0, 0, angle - M_PI / 2);
    };
    const auto add = [&](std::uint64_t scan) {
        MapUpdate update = room.add(squareScanAt(placeAt(scan), static_cast<unsigned>(scan)));
        EXPECT_TRUE(update.keyScan && update.keyScan->id == scan);
        return update;
    };
    for (std::uint64_t scan = 1; scan <= 12; ++scan) EXPECT_FALSE(add(scan).loop);
    std::vector<ScanPose> poses = room.poses();
    const Pose roomInMap = poses.front().scanInMap * placeAt(1).inverse();
    const Pose turned = roomInMap * poseFrom({0, 0, 0}, 0, 0, degrees(50)) * roomInMap.inverse();
    for (std::size_t i = poses.size() / 2; i < poses.size(); ++i)
        poses[i].scanInMap = turned * poses[i].scanInMap;
    room.mapper.follow(poses);
    int wrong = 0;
    for (std::uint64_t scan = 13; scan <= 40; ++scan) {
        const MapUpdate update = add(scan);
        if (!update.loop) continue;
        for (const Link& link : update.loop->links) {
            const Pose truth = placeAt(link.from).inverse() * placeAt(link.to);
            wrong += link.active && angleBetween(link.pose, truth) > degrees(2) ? 1 : 0;
        }
    }
    return wrong;
}

TEST(LoopsInTwins, AMapThatWouldTurnByFarMoreThanItErrsDoesNotCloseByItself) {
    EXPECT_GT(wrongLoops(degrees(180)), 0) << "two places agree, as far off as the map may be";
    EXPECT_EQ(wrongLoops(LoopSettings{}.nearTurn), 0);
}

/// A hall of pillars, each 1.6 m alike, of which a scan sees 5 m.
LiveScan pillarScanAt(const Pose& sensorInMap, unsigned seed) {
    constexpr double Apart = 1.6;
    BoxScene scene;
    const Eigen::Vector2d here = sensorInMap.translation().head<2>();
    for (int x = -4; x <= 8; ++x) {
        for (int y = -4; y <= 8; ++y) {
            const Eigen::Vector2d pillar(Apart * x, Apart * y);
            if ((pillar - here).norm() < 5.5) scene.add(pillar, 0, 0.7, 0.6, 2.2);
        }
    }
    LiveScan live = scanAt(sensorInMap, seed);
    Scan scan = scene.scan(sensorInMap, seed);
    scan.end = live.scan->end;
    scan.sensorInOdom = live.scan->sensorInOdom;
    std::erase_if(scan.points, [](const Eigen::Vector3f& point) { return point.norm() > 5.0F; });
    live.scan = std::make_shared<const Scan>(std::move(scan));
    return live;
}

/// Loops that close by themselves, right and wrong ones, after a way round such a hall of which the map has
/// the second half off by @p error [m], and may err by @p drift of it.
std::pair<int, int> loopsAmongPillars(double error, double drift, double alike = LoopSettings{}.alike) {
    constexpr double Step = 0.4, Side = 4.8;  // [m]
    LiveSettings settings = closing(LoopSettings{}.nearTurn);
    settings.loops.drift = settings.loops.openDrift = drift;
    settings.loops.alike = alike;
    MappedRoom room(settings);
    const auto placeAt = [&](std::uint64_t scan) {
        const double way = std::fmod(Step * static_cast<double>(scan - 1), 4.0 * Side);
        const auto part = [&](double from) { return std::clamp(way - from, 0.0, Side); };
        const double x = part(0.0) - part(2.0 * Side), y = part(Side) - part(3.0 * Side);
        return poseFrom({0.8 + x, 0.8 + y, 0}, 0, 0, 0);
    };
    const auto add = [&](std::uint64_t scan) {
        return room.add(pillarScanAt(placeAt(scan), static_cast<unsigned>(scan)));
    };
    for (std::uint64_t scan = 1; scan <= 36; ++scan) EXPECT_FALSE(add(scan).loop);
    std::vector<ScanPose> poses = room.poses();
    for (std::size_t i = 18; i < poses.size(); ++i)
        poses[i].scanInMap.pretranslate(Eigen::Vector3d(error, 0, 0));
    room.mapper.follow(poses);
    std::pair<int, int> loops;
    for (std::uint64_t scan = 37; scan <= 54; ++scan) {
        const MapUpdate update = add(scan);
        if (!update.loop) continue;
        for (const Link& link : update.loop->links) {
            const Pose truth = placeAt(link.from).inverse() * placeAt(link.to);
            if (link.active) ++(distanceBetween(link.pose, truth) < 0.1 ? loops.first : loops.second);
        }
    }
    return loops;
}

TEST(LoopsInTwins, WhereAPlaceBesideFitsAsWellNothingClosesByItself) {
    constexpr double NothingIsAlike = 2.0;
    EXPECT_GT(loopsAmongPillars(1.0, 0.1, NothingIsAlike).second, 0) << "two places agree";
    const auto [right, wrong] = loopsAmongPillars(1.0, 0.1);
    EXPECT_EQ(right, 0);
    EXPECT_EQ(wrong, 0) << "the next pillars are nearer to where the map has the scan";
}

TEST(LoopsInTwins, WhereTheMapCannotErrAsFarAsThePlaceBesideItCloses) {
    const auto [right, wrong] = loopsAmongPillars(0.2, 0.02);
    EXPECT_GT(right, 0);
    EXPECT_EQ(wrong, 0);
}

}  // namespace
}  // namespace leitstand::test
