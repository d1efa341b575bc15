#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "core/event/picture_samples.h"
#include "core/mission/coverage/missed_floor.h"
#include "core/mission/coverage/searched_floor.h"
#include "tests/core/mission/coverage/search_scene.h"

namespace leitstand::test {
namespace {

CoverageMapPtr coverageOf(const std::vector<SearchView>& views, const CoverageSettings& settings = {}) {
    SearchBook book(settings);
    book.add(SearchScene{}.scan());
    for (const SearchView& view : views) EXPECT_TRUE(book.add(view));
    return book.coverage(SearchScene::trail());
}

TEST(CoverageMap, ACameraSeesItsFieldAndNotBehindWalls) {
    const auto map = coverageOf({viewFrom({-2.0, 0.0, 0.5}, 0.0)});
    EXPECT_TRUE(sees(*map, SearchSensor::Camera, 0.0, 0.0));
    EXPECT_FALSE(sees(*map, SearchSensor::Camera, 2.0, 0.0)) << "behind the wall";
    for (double y = -1.8; y < 0.7; y += 0.05) {
        for (double x = 1.25; x < 2.8; x += 0.05)
            EXPECT_FALSE(sees(*map, SearchSensor::Camera, x, y)) << "through a gap, x " << x << ", y " << y;
    }
    EXPECT_FALSE(sees(*map, SearchSensor::Camera, -3.0, 0.0)) << "behind the camera";
    // 640 pixels at a focal length of 640: half a metre aside for each metre ahead.
    EXPECT_TRUE(sees(*map, SearchSensor::Camera, 0.05, 0.85));
    EXPECT_FALSE(sees(*map, SearchSensor::Camera, 0.05, 1.25));
    EXPECT_TRUE(sees(*map, SearchSensor::Camera, 0.05, -0.85));
    EXPECT_FALSE(sees(*map, SearchSensor::Camera, 0.05, -1.25));
    EXPECT_FALSE(sees(*map, SearchSensor::Camera, -1.75, 0.0)) << "below the picture's lower edge";
    EXPECT_FALSE(sees(*map, SearchSensor::Infrared, 0.0, 0.0)) << "that one did not look";
}

TEST(CoverageMap, FloorOverTheUpperEdgeOfThePictureIsNotSeen) {
    const auto down = coverageOf({viewFrom({-3.5, 0.0, 0.5}, 0.0, degrees(45))});
    EXPECT_TRUE(sees(*down, SearchSensor::Camera, -3.15, 0.0));
    EXPECT_FALSE(sees(*down, SearchSensor::Camera, -1.0, 0.0));
}

TEST(CoverageMap, ABodyHasToSpanEnoughPixels) {
    CoverageSettings far;
    far.cameraPixels = 0.4 * 640 / 2.0;  // 0.4 m, two metres off
    const auto map = coverageOf({viewFrom({-2.0, 0.0, 0.5}, 0.0)}, far);
    EXPECT_TRUE(sees(*map, SearchSensor::Camera, -0.2, 0.05));
    EXPECT_FALSE(sees(*map, SearchSensor::Camera, 0.2, 0.05));
    CoverageSettings some;
    some.cameraPixels = 64;
    const auto near = coverageOf({viewFrom({-2.0, 0.0, 0.5}, 0.0)}, some);
    const auto& ground = near->ground();
    const auto well = [&](double x) {
        return near->quality(SearchSensor::Camera, static_cast<std::size_t>(ground.cellAt({x, 0.05})));
    };
    EXPECT_GT(well(-1.0), well(0.5)) << "nearer is better";
    EXPECT_LT(near->quality(SearchSensor::Camera, static_cast<std::size_t>(ground.cellAt({-3.0, 0.0}))),
              0.0F);
    // An infrared camera needs fewer of its pixels.
    EXPECT_GT(viewFrom({0, 0, 0}, 0, 0, SearchSensor::Infrared).range(far),
              viewFrom({0, 0, 0}, 0).range(far));
}

TEST(CoverageMap, WhatIsFartherThanAnybodyLooksIsNotSearchedHoweverManyPixelsItSpans) {
    const auto through = [](SearchSensor sensor) {  // the door
        return coverageOf({viewFrom({-3.8, 1.5, 0.5}, 0.0, 0.0, sensor)});
    };
    const auto camera = through(SearchSensor::Camera), infrared = through(SearchSensor::Infrared);
    EXPECT_TRUE(sees(*camera, SearchSensor::Camera, 0.8, 1.5)) << "4.6 m";
    EXPECT_FALSE(sees(*camera, SearchSensor::Camera, 1.8, 1.5))
        << "5.6 m: codes and motion are not looked for";
    EXPECT_TRUE(sees(*infrared, SearchSensor::Infrared, 1.8, 1.5));
    EXPECT_FALSE(sees(*infrared, SearchSensor::Infrared, 2.6, 1.5)) << "6.4 m: nor is warmth";
}

TEST(CoverageMap, AScannerSearchesWhereItsPointsAreDenseEnough) {
    const auto map = coverageOf({});
    EXPECT_TRUE(sees(*map, SearchSensor::Scanner, -1.5, 0.5));
    EXPECT_FALSE(sees(*map, SearchSensor::Scanner, 2.0, 0.0)) << "behind the wall";
    CoverageSettings strict;
    strict.scannerPoints = 1e6;
    EXPECT_EQ(coverageOf({}, strict)->seenArea(SearchSensor::Scanner), 0.0);
    EXPECT_GT(map->seenArea(SearchSensor::Scanner), 10.0);
}

TEST(CoverageMap, WhatWasSearchedMovesWithItsScan) {
    SearchBook book;
    book.add(SearchScene{}.scan());
    ASSERT_TRUE(book.add(viewFrom({-2.0, 0.0, 0.5}, 0.0)));
    const Pose moved = poseFrom({10.0, 5.0, 0.0}, 0, 0, degrees(90));
    book.place(1, moved * SearchScene{}.scan().scanInMap, true);
    const Eigen::Vector3d robot = moved * Eigen::Vector3d(-2.0, 0.0, 0.0);
    const std::vector<Eigen::Vector3d> trail = {robot};
    const auto map = book.coverage(trail);
    const Eigen::Vector3d ahead = moved * Eigen::Vector3d(0.0, 0.0, 0.0),
                          hidden = moved * Eigen::Vector3d(2.0, 0.0, 0.0);
    EXPECT_TRUE(sees(*map, SearchSensor::Camera, ahead.x(), ahead.y()));
    EXPECT_FALSE(sees(*map, SearchSensor::Camera, hidden.x(), hidden.y()));
    EXPECT_FALSE(sees(*map, SearchSensor::Camera, 0.0, 0.0)) << "where it was before";
    book.place(1, moved, false);
    EXPECT_EQ(book.coverage(trail)->ground().size(), 0U) << "a scan that does not count tells nothing";
}

TEST(CoverageMap, ClearedIsWhatACameraLookedAt) {
    const auto map = coverageOf({viewFrom({-2.0, 0.0, 0.5}, 0.0)});
    EXPECT_GE(map->cleared({-1.0, 0.05}), 0.0F);
    EXPECT_LE(map->cleared({-1.0, 0.05}), 1.0F);
    EXPECT_LT(map->cleared({2.0, 0.0}), 0.0F);
    EXPECT_LT(map->cleared({-3.0, 0.0}), 0.0F) << "a scanner alone clears nothing";
    EXPECT_LT(map->cleared({1e9, 0.0}), 0.0F);
}

TEST(MissedFloor, TheLargestPieceComesFirst) {
    // Half the first room is looked at; the room behind the wall is not.
    const auto map = coverageOf({viewFrom({-2.0, 0.0, 0.5}, 0.0)});
    const auto regions = missed(*map, SearchSensor::Camera);
    ASSERT_FALSE(regions.empty());
    for (std::size_t i = 1; i < regions.size(); ++i) EXPECT_LE(regions[i].area, regions[i - 1].area);
    double sum = 0.0;
    for (const MissedRegion& region : regions) {
        sum += region.area;
        EXPECT_GE(region.area, 0.25);
        EXPECT_TRUE(reachable(map->ground(), region.place.x(), region.place.y()));
        EXPECT_FALSE(sees(*map, SearchSensor::Camera, region.place.x(), region.place.y()));
        EXPECT_TRUE((region.low.array() < region.high.array()).all());
    }
    EXPECT_NEAR(sum + map->seenArea(SearchSensor::Camera), map->ground().reachableArea(), 0.5);
    EXPECT_TRUE(missed(CoverageMap(SearchGround{}), SearchSensor::Camera).empty());
}

TEST(SearchBook, ViewsThatHardlyDifferAreOne) {
    SearchBook book;
    book.add(SearchScene{}.scan());
    EXPECT_TRUE(book.add(viewFrom({-2.0, 0.0, 0.5}, 0.0)));
    EXPECT_FALSE(book.add(viewFrom({-2.0, 0.05, 0.5}, degrees(3))));
    EXPECT_TRUE(book.add(viewFrom({-2.0, 0.15, 0.5}, 0.0)));
    EXPECT_TRUE(book.add(viewFrom({-2.0, 0.0, 0.5}, degrees(7))));
    EXPECT_TRUE(book.add(viewFrom({-2.0, 0.0, 0.5}, 0.0, degrees(8), SearchSensor::Infrared)));
    SearchView broken = viewFrom({0, 0, 0}, 0.0);
    broken.cameraInScan.translation().x() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(book.add(broken));
    EXPECT_EQ(book.views(), 4U);
    EXPECT_EQ(book.allViews().size(), 4U);
    EXPECT_EQ(book.leftOut(), 0U) << "nothing of it would have told anything";
}

/// A camera that drives to and fro in the first room and looks all about, for very long.
std::vector<SearchView> longWay(std::size_t views) {
    std::vector<SearchView> all;
    for (std::size_t i = 0; i < views; ++i) {
        const double along = 0.013 * static_cast<double>(i);
        all.push_back(viewFrom({-2.5 + std::sin(along), 1.2 * std::cos(0.7 * along), 0.5}, 2.1 * along));
    }
    return all;
}

TEST(SearchBook, ManyViewsAreThinnedAndWhatTheySawStays) {
    constexpr std::size_t Most = 60;
    CoverageSettings bounded, bottomless;
    bottomless.mostViews = bottomless.mostViewsOfScan = 1'000'000;
    CoverageSettings ofScan = bottomless;
    bounded.mostViewsOfScan = 1'000'000;
    bounded.mostViews = ofScan.mostViewsOfScan = Most;
    SearchBook small(bounded), smallScan(ofScan), large(bottomless);
    for (SearchBook* book : {&small, &smallScan, &large}) {
        book->add(SearchScene{}.scan());
        for (const SearchView& view : longWay(1000)) (void)book->add(view);
        EXPECT_EQ(book->leftOut(), 0U);
        EXPECT_EQ(book->allViews().size(), book->views());
    }
    EXPECT_GT(large.views(), 3 * Most);
    const auto seen = [](const SearchBook& book) {
        return book.coverage(SearchScene::trail())->seenArea(SearchSensor::Camera);
    };
    const double all = seen(large);
    for (const SearchBook* book : {&small, &smallScan}) {
        EXPECT_LE(book->views(), Most);
        EXPECT_GT(book->views(), Most / 4);
        EXPECT_GT(seen(*book), 0.97 * all);
        EXPECT_LE(seen(*book), all + 1e-9);
    }
}

TEST(SearchBook, WhatDoesNotFitAtAllIsCounted) {
    CoverageSettings few;
    few.mostViewsOfScan = 1;
    SearchBook book(few);
    EXPECT_TRUE(book.add(viewFrom({-2.0, 0.0, 0.5}, 0.0)));
    EXPECT_FALSE(book.add(viewFrom({-2.0, 0.3, 0.5}, 0.0))) << "about the same, where memory is short";
    EXPECT_EQ(book.leftOut(), 0U);
    EXPECT_FALSE(book.add(viewFrom({-2.0, 1.0, 0.5}, 0.0)));
    EXPECT_EQ(book.leftOut(), 1U);
    SearchView elsewhere = viewFrom({-2.0, 1.0, 0.5}, 0.0);
    elsewhere.scan = 2;
    EXPECT_TRUE(book.add(elsewhere)) << "another scan has room of its own";
    EXPECT_EQ(book.views(), 2U);
}

TEST(SearchField, CamerasBelowMirrorsSeeARing) {
    CameraInfoSample info;
    info.width = info.height = 480;
    info.distortionModel = "mei";
    info.distortion = {0, 0, 0, 0, 1.0};
    info.intrinsics = {220, 0, 240, 0, 220, 240, 0, 0, 1};
    const auto field = fieldOf(info);
    ASSERT_TRUE(field);
    EXPECT_GT(field->outer, degrees(80));
    EXPECT_TRUE(field->holds({1.0, 0.0, 0.5}));
    EXPECT_TRUE(field->holds({-1.0, 0.5, 0.5})) << "all round";
    EXPECT_FALSE(field->holds({0.1, 0.0, -1.0}));
    EXPECT_GT(field->pixelsPerRadian, 50);
    EXPECT_FALSE(fieldOf({})) << "not calibrated";
}

TEST(SearchField, AFisheyeSeesACircleUpToItsNearestEdge) {
    CameraInfoSample info;
    info.width = 848;
    info.height = 800;
    info.distortionModel = "equidistant";
    info.distortion = {0.0, 0.0, 0.0, 0.0};
    info.intrinsics = {285.0, 0.0, 424.0, 0.0, 285.0, 400.0, 0.0, 0.0, 1.0};
    const auto field = fieldOf(info);
    ASSERT_TRUE(field);
    EXPECT_NEAR(field->outer, 400.0 / 285.0, degrees(1.5)) << "80 degrees";
    EXPECT_NEAR(field->pixelsPerRadian, 285.0, 3.0);
    EXPECT_TRUE(field->holds({std::sin(degrees(70)), 0.0, std::cos(degrees(70))}));
    EXPECT_FALSE(field->holds({std::sin(degrees(85)), 0.0, std::cos(degrees(85))}));
}

TEST(CoverageByStorey, EachIsSearchedFromWhereRobotsWereOnIt) {
    SearchBook book;
    constexpr double Up = 3.0;
    for (std::uint64_t i = 0; i < 12; ++i) {
        ReportScan scan = SearchScene{}.scan();
        scan.id = i + 1;
        if (i >= 6) scan.scanInMap.translation().z() += Up;
        book.add(scan);
    }
    SearchView above = viewFrom({-2.0, 0.0, 0.5}, 0.0);
    above.scan = 7;  // the camera looked about upstairs only
    ASSERT_TRUE(book.add(above));
    std::vector<Eigen::Vector3d> trail = SearchScene::trail();
    for (const Eigen::Vector3d& place : SearchScene::trail())
        trail.push_back(place + Eigen::Vector3d(0, 0, Up));
    const std::vector<StoreyCoverage> storeys = book.byStorey(trail);
    ASSERT_EQ(storeys.size(), 2U);
    EXPECT_EQ(storeys[0].storey.number, 0);
    EXPECT_EQ(storeys[1].storey.number, 1);
    const auto alone = coverageOf({});
    for (const StoreyCoverage& one : storeys) {
        EXPECT_NEAR(one.map->ground().reachableArea(), alone->ground().reachableArea(), 0.2);
        EXPECT_NEAR(one.map->seenArea(SearchSensor::Scanner), alone->seenArea(SearchSensor::Scanner), 0.2);
    }
    EXPECT_EQ(storeys[0].map->seenArea(SearchSensor::Camera), 0.0);
    EXPECT_GT(storeys[1].map->seenArea(SearchSensor::Camera), 1.0);
    const auto pieces = missed(storeys, SearchSensor::Camera);
    ASSERT_FALSE(pieces.empty());
    EXPECT_EQ(pieces.front().storey, 0) << "all of it was missed";
    EXPECT_TRUE(std::is_sorted(pieces.begin(), pieces.end(),
                               [](const MissedRegion& a, const MissedRegion& b) { return a.area > b.area; }));
    const SearchedFloorPtr reported = searchedFloorOf(storeys);
    ASSERT_EQ(reported->storeys.size(), 2U);
    EXPECT_NEAR(reported->reachable, reported->storeys[0].reachable + reported->storeys[1].reachable, 1e-9);
    EXPECT_TRUE(std::any_of(reported->by(SearchSensor::Camera).tint.patches.begin(),
                            reported->by(SearchSensor::Camera).tint.patches.end(),
                            [](const FloorPatch& patch) { return patch.seen && patch.height > Up - 0.1; }));
}

}  // namespace
}  // namespace leitstand::test
