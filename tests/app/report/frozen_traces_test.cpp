// What a report shows of evidence that is no picture.
#include "app/services/handin/frozen_traces.h"

#include <chrono>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "app/services/handin/scan_picture.h"

namespace leitstand::test {
namespace {

Time at(int seconds) {
    return Time(std::chrono::seconds(1'700'000'000 + seconds));
}

TEST(GasTraces, AreJoinedByRobotAndTimeAndPartedByPauses) {
    FindPages pages;
    for (const int seconds : {20, 0, 10, 200, 210}) pages.gas.push_back({"kurt3d", {{at(seconds), 400.0}}});
    pages.gas.push_back({"crawler", {{at(5), 500.0}}});
    joinGas(pages);
    ASSERT_EQ(pages.gas.size(), 3U);
    EXPECT_EQ(pages.gas[0].robot, "crawler");
    ASSERT_EQ(pages.gas[1].readings.size(), 3U);
    EXPECT_EQ(pages.gas[1].readings.front().at, at(0));
    EXPECT_EQ(pages.gas[1].readings.back().at, at(20));
    EXPECT_EQ(pages.gas[2].readings.size(), 2U) << "three minutes later is another find's";
}

TEST(GasTraces, OfNothingAreNone) {
    FindPages pages;
    joinGas(pages);
    EXPECT_TRUE(pages.gas.empty());
}

Rgb pixel(const MapPicture& map, const Eigen::Vector2d& place) {
    const Eigen::Vector2d found = map.pixelOf(place);
    return map.at(static_cast<int>(found.x()), static_cast<int>(found.y()));
}

TEST(ScanPicture, ShowsPointsFindAndRobotWhereTheyAre) {
    std::vector<Eigen::Vector3d> points;
    for (double y = -1.0; y <= 1.0; y += 0.004) {
        points.emplace_back(3.0, y, -0.2);  // low
        points.emplace_back(3.25, y, 1.8);  // high
    }
    points.emplace_back(std::nan(""), 0.0, 0.0);
    points.emplace_back(1e9, 0.0, 0.0);
    ScanPictureMarks marks;
    marks.find = Eigen::Vector3d(2.0, 0.5, 0.4);
    marks.baseInMap = poseFrom({0.3, 0.5, 0.0}, 0, 0, 0);
    const MapPicture map = scanPicture(points, marks);
    EXPECT_EQ(map.picture.width, map.picture.height);
    EXPECT_EQ(pixel(map, {2.0, 0.5}), (Rgb{0xD5, 0x5E, 0x00})) << "the find";
    EXPECT_EQ(pixel(map, {0.3, 0.5}), (Rgb{0, 0, 0})) << "the robot";
    EXPECT_EQ(pixel(map, {0.5, 0.5}), (Rgb{0, 0, 0})) << "looks ahead";
    EXPECT_NE(pixel(map, {0.05, 0.5}), (Rgb{0, 0, 0})) << "is notched behind";
    EXPECT_EQ(pixel(map, {2.995, -0.4}), (Rgb{68, 1, 84})) << "low is dark";
    EXPECT_EQ(pixel(map, {3.245, -0.4}), (Rgb{253, 231, 37})) << "high is yellow";
    EXPECT_EQ(pixel(map, {2.6, -0.4}), (Rgb{255, 255, 255})) << "paper";
}

TEST(ScanPicture, WithoutAnythingIsPaper) {
    const MapPicture map = scanPicture({}, {});
    EXPECT_GT(map.picture.width, 100);
    EXPECT_EQ(pixel(map, {0.4, 0.4}), (Rgb{255, 255, 255}));
}

}  // namespace
}  // namespace leitstand::test
