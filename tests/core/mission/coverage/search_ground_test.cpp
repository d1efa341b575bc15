#include <limits>

#include <gtest/gtest.h>

#include "tests/core/mission/coverage/search_scene.h"

namespace leitstand::test {
namespace {

SearchGround groundOf(const SearchScene& scene) {
    const std::vector<ReportScan> scans = {scene.scan()};
    return SearchGround::of(scans, SearchScene::trail());
}

TEST(SearchGround, RobotsReachWhatADoorLeadsTo) {
    const SearchGround open = groundOf({});
    EXPECT_TRUE(reachable(open, -3.5, 1.5));
    EXPECT_TRUE(reachable(open, 2.0, 0.0)) << "behind the wall, through the door";
    EXPECT_FALSE(reachable(open, 3.5, -1.5)) << "the cabin has no door";
    EXPECT_FALSE(reachable(open, 1.03, 0.0)) << "a wall is no floor";
    EXPECT_NEAR(open.reachableArea(), 8.0 * 4.0 - 1.0, 2.0);
    for (double x = -3.8; x < 0.8; x += 0.05) {
        for (double y = -1.8; y < 1.8; y += 0.05)
            EXPECT_TRUE(reachable(open, x, y)) << "a hole in the floor, x " << x << ", y " << y;
    }
    const SearchGround shut = groundOf({.door = false});
    EXPECT_TRUE(reachable(shut, -3.5, 1.5));
    EXPECT_FALSE(reachable(shut, 2.0, 0.0));
    EXPECT_NEAR(shut.reachableArea(), 5.0 * 4.0, 2.0);
}

TEST(SearchGround, RobotsThatWereSeenOnTheirWayAreNoObstacles) {
    const ReportScan seen = SearchScene{}.scan();
    auto scan = std::make_shared<Scan>(*seen.scan);
    for (double angle = 0.0; angle < 6.3; angle += 0.1) {  // a robot of half a metre about (-2.5, 0)
        scan->points.emplace_back(static_cast<float>(-0.5 + 0.25 * std::cos(angle)),
                                  static_cast<float>(0.25 * std::sin(angle)), -0.2F);
        scan->labels.push_back(Label::Wall);
    }
    std::vector<ReportScan> scans = {seen};
    scans.front().scan = scan;
    const SearchGround ground = SearchGround::of(scans, SearchScene::trail());
    EXPECT_TRUE(reachable(ground, 2.0, 0.0));
    EXPECT_FALSE(ground.hides({-3.2, 0.0, 0.4}, {-1.5, 0.0, 0.15}));
    const std::vector<Eigen::Vector3d> elsewhere = {{-3.5, 1.0, 0.0}};
    EXPECT_TRUE(SearchGround::of(scans, elsewhere).hides({-3.2, 0.0, 0.4}, {-1.5, 0.0, 0.15}));
}

TEST(SearchGround, AWallThatARobotPassesCloselyStaysAWall) {
    // The wall across stands at x = 1.03; cells begin anywhere, so it is passed in steps of a tenth of one.
    for (double off = 0.0; off < 0.1; off += 0.01) {
        const ReportScan seen = SearchScene{}.scan();
        std::vector<ReportScan> scans = {seen};
        scans.front().scanInMap.translation() += Eigen::Vector3d(off, off, 0.0);
        std::vector<Eigen::Vector3d> trail;
        for (double y = -1.6; y < 1.6; y += 0.03) trail.emplace_back(1.03 + off - 0.3, y, 0.0);
        for (double x = -3.5; x < 1.03 - 0.3; x += 0.03) trail.emplace_back(x, off - 2.03 + 0.3, 0.0);
        const SearchGround ground = SearchGround::of(scans, trail);
        for (double y = -1.8; y < 0.9; y += 0.05)
            EXPECT_TRUE(ground.hides({-1.0, y + off, 0.5}, {2.0, y + off, 0.15})) << off << ", y " << y;
        for (double x = -3.8; x < 0.9; x += 0.05) {
            const auto wall = ground.cellAt({x + off, off - 2.03});
            ASSERT_GE(wall, 0);
            EXPECT_FALSE(ground.isFloor(static_cast<std::size_t>(wall))) << off << ", x " << x;
        }
    }
}

TEST(SearchGround, AWallHidesAndALowOneDoesNot) {
    const SearchGround wall = groundOf({});
    EXPECT_TRUE(wall.hides({-2.0, 0.0, 0.5}, {2.0, 0.0, 0.15}));
    EXPECT_TRUE(wall.hides({2.0, 0.0, 0.15}, {-2.0, 0.0, 0.5})) << "to and fro";
    EXPECT_FALSE(wall.hides({-2.0, 0.0, 0.5}, {0.5, 0.0, 0.15}));
    EXPECT_FALSE(wall.hides({-2.0, 1.5, 0.5}, {2.0, 1.5, 0.15})) << "through the door";
    EXPECT_FALSE(wall.hides({-2.0, 0.0, 0.5}, {-2.0, 0.0, 0.15})) << "below oneself";
    const SearchGround low = groundOf({.wallHeight = 0.2});
    EXPECT_FALSE(low.hides({0.0, 0.0, 0.8}, {2.0, 0.0, 0.15})) << "over it";
    EXPECT_TRUE(low.hides({-2.0, 0.0, 0.14}, {3.0, 0.0, 0.13}));
}

TEST(SearchGround, WithoutScansOrWithHostileOnesThereIsNothingToSearch) {
    const SearchGround none = SearchGround::of({}, {});
    EXPECT_EQ(none.size(), 0U);
    EXPECT_EQ(none.reachableArea(), 0.0);
    EXPECT_FALSE(none.hides({0, 0, 0}, {1, 1, 1}));
    auto scan = std::make_shared<Scan>();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    scan->points = {{nan, 0, 0}, {1e30F, 0, 0}, {0.5F, 0, 0}, {3e4F, 3e4F, 0}};
    scan->labels.assign(4, Label::Floor);
    std::vector<ReportScan> scans = {{.id = 1, .scan = scan}, {.id = 2, .scan = scan}};
    scans.back().scanInMap.translation() = Eigen::Vector3d(1e9, -1e9, 0);
    const std::vector<Eigen::Vector3d> trail = {{0.5, 0, 0}, {1e12, nan, 0}};
    EXPECT_LT(SearchGround::of(scans, trail).size(), 4'000'001U);
}

TEST(SearchGround, FarHallsGetCoarserCells) {
    auto scan = std::make_shared<Scan>();
    scan->points = {{0, 0, 0}, {210, 0, 0}, {0, 210, 0}};
    scan->labels.assign(3, Label::Floor);
    const std::vector<ReportScan> scans = {{.id = 1, .scan = scan}};
    const SearchGround ground = SearchGround::of(scans, {});
    EXPECT_GT(ground.cell(), 0.19);
    EXPECT_LE(ground.size(), 2002U * 2002U);
}

}  // namespace
}  // namespace leitstand::test
