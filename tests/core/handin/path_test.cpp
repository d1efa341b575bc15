#include <algorithm>
#include <chrono>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/handin/map/robot_path.h"
#include "core/handin/map/ways.h"

namespace leitstand::test {
namespace {

Time at(double seconds) {
    return Time(std::chrono::nanoseconds(static_cast<std::int64_t>(seconds * 1e9)));
}
Pose place(double x, double y, double yaw = 0.0) {
    return poseFrom({x, y, 0.0}, 0.0, 0.0, yaw);
}

/// 10 s straight on at 0.5 m/s, in an odometry that begins elsewhere and drifts to the left.
std::vector<PathPose> driftingOdometry() {
    std::vector<PathPose> poses;
    for (int i = 0; i <= 200; ++i) {
        const double t = 0.05 * i;
        poses.push_back({at(t), place(7.0 + 0.5 * t, 3.0 + 0.02 * t)});
    }
    return poses;
}

TEST(JoinedPath, OdometryIsPutWhereTheScansHaveIt) {
    const std::vector<PathAnchor> anchors = {
        {at(1), place(0.5, 0)}, {at(5), place(2.5, 0)}, {at(9), place(4.5, 0)}};
    const auto path = joinedPath(anchors, driftingOdometry(), 0.02);
    ASSERT_GT(path.size(), 100u);
    for (const PathPose& pose : path) {
        const double t = std::chrono::duration<double>(pose.time.time_since_epoch()).count();
        EXPECT_NEAR(pose.baseInMap.translation().x(), 0.5 * t, 1e-6);
        const bool between = t >= 1.0 && t <= 9.0;
        EXPECT_NEAR(pose.baseInMap.translation().y(), 0.0, between ? 1e-6 : 0.03) << t;
    }
    EXPECT_EQ(path.back().time, at(10));
}

TEST(JoinedPath, WithoutOdometryItIsTheScans) {
    const std::vector<PathAnchor> anchors = {{at(1), place(0.5, 0)}, {at(5), place(2.5, 0)}};
    EXPECT_EQ(joinedPath(anchors, {}).size(), 2u);
    EXPECT_TRUE(joinedPath({}, driftingOdometry()).empty()) << "nobody knows where that is in the map";
}

TEST(JoinedPath, AnOdometryThatBeganAnewMakesNoWay) {
    auto odometry = driftingOdometry();
    for (std::size_t i = 100; i < odometry.size(); ++i)
        odometry[i].baseInMap = place(0.5 * 0.05 * double(i) - 2.5, 0);
    const std::vector<PathAnchor> anchors = {{at(1), place(0.5, 0)}, {at(9), place(4.5, 0)}};
    for (const PathPose& pose : joinedPath(anchors, odometry))
        EXPECT_LT(std::abs(pose.baseInMap.translation().y()), 0.2);
}

TEST(JoinedPath, WhereNothingWasHeardForLongTheWayIsNotKnown) {
    // Driven on for 20 s while the station was away, and stood there for 20 s more.
    auto odometry = driftingOdometry();
    const std::size_t before = odometry.size();
    for (int i = 0; i <= 20; ++i) odometry.push_back({at(30.0 + i), place(12.0 + 4.0, 3.2)});
    for (int i = 0; i <= 20; ++i) odometry.push_back({at(51.0 + 0.05 * i), place(16.0 + 0.025 * i, 3.2)});
    RobotPath path{"kurt3d", joinedPath(std::vector<PathAnchor>{{at(1), place(0.5, 0)}}, odometry)};
    const auto gaps = std::count_if(path.poses.begin(), path.poses.end(),
                                    [](const PathPose& pose) { return pose.afterGap; });
    EXPECT_EQ(gaps, 1) << "a robot that stands leaves none";
    EXPECT_NEAR(path.length(), 0.5 * 10.0 + 0.5, 0.05);
    const auto gap = std::find_if(path.poses.begin(), path.poses.end(),
                                  [](const PathPose& pose) { return pose.afterGap; });
    EXPECT_EQ(gap->time, odometry[before].time);
}

RobotPath pathThrough(std::string robot, const std::vector<Eigen::Vector2d>& corners) {
    RobotPath path{std::move(robot), {}};
    double t = 0.0;
    for (std::size_t i = 1; i < corners.size(); ++i) {
        for (int step = 0; step <= 50; ++step) {
            const Eigen::Vector2d point = corners[i - 1] + step / 50.0 * (corners[i] - corners[i - 1]);
            path.poses.push_back({at(t += 0.1), place(point.x(), point.y())});
        }
    }
    return path;
}

TEST(WayFinder, FollowsTheTrailAndTakesWhereItCrossesItself) {
    // Out to x = 4, around a square and back over the trail at x = 2.
    const std::vector<RobotPath> paths = {pathThrough("kurt3d", {{0, 0}, {4, 0}, {4, 4}, {2, 4}, {2, -2}})};
    const WayFinder finder(paths);
    const Way way = finder.to({2.3, -1.5, 0.4});
    EXPECT_NEAR(way.length, 2.0 + 1.5 + 0.3, 0.35) << "not around the square";
    EXPECT_NEAR(way.lastPiece, 0.3, 0.16);
    EXPECT_EQ(way.robot, "kurt3d");
    EXPECT_NEAR(way.points.front().x(), 0.0, 0.01);
    EXPECT_NEAR(way.points.back().z(), 0.4, 1e-9) << "it ends at the victim";
    EXPECT_NEAR(paths[0].length(), 4 + 4 + 2 + 6, 0.01);
    double sum = 0.0;
    for (std::size_t i = 2; i < way.points.size(); ++i) sum += (way.points[i - 1] - way.points[i - 2]).norm();
    EXPECT_NEAR(sum + way.lastPiece, way.length, 1e-6);
}

TEST(WayFinder, ChangesFromOneTrailToAnother) {
    const std::vector<RobotPath> paths = {pathThrough("kurt3d", {{0, 0}, {4, 0}}),
                                          pathThrough("crawler", {{-6, 2}, {4, 2}, {4, 0.1}, {6, 0.1}})};
    const Way way = WayFinder(paths).to({6.0, 0.0, 0.0});
    EXPECT_EQ(way.robot, "kurt3d");
    EXPECT_NEAR(way.length, 6.1, 0.3);
}

TEST(WayFinder, GoesStraightOverAGapOnlyWhereNoOtherWayIsKnown) {
    RobotPath kurt = pathThrough("kurt3d", {{0, 0}, {4, 0}, {4, 4}, {0.5, 4}});
    RobotPath later = pathThrough("kurt3d", {{0.5, 2}, {3.5, 2}});
    later.poses.front().afterGap = true;
    kurt.poses.insert(kurt.poses.end(), later.poses.begin(), later.poses.end());
    const Way way = WayFinder(std::vector<RobotPath>{kurt}).to({3.5, 2.0, 0.0});
    EXPECT_NEAR(way.length, 4.0 + 4.0 + 3.5 + 2.0 + 3.0, 0.25) << "over the gap";
    EXPECT_NEAR(way.points.front().norm(), 0.0, 0.01) << "from where it began, not from behind the gap";
    const RobotPath crawler = pathThrough("crawler", {{-1, 0}, {0, 0}, {3.5, 1.8}});
    const Way shorter = WayFinder(std::vector<RobotPath>{kurt, crawler}).to({2.0, 2.0, 0.0});
    EXPECT_NEAR(shorter.length, Eigen::Vector2d(3.5, 1.8).norm() + 1.5, 0.4) << "as the other robot went";
}

TEST(WayFinder, TellsWhereNoRobotWas) {
    const std::vector<RobotPath> paths = {pathThrough("kurt3d", {{0, 0}, {4, 0}})};
    EXPECT_TRUE(WayFinder(paths).to({0.0, 20.0, 0.0}).points.empty());
    EXPECT_TRUE(WayFinder({}).to({0.0, 0.0, 0.0}).points.empty());
}

}  // namespace
}  // namespace leitstand::test
