// The last piece of a way leads where one can go: neither through walls nor from another storey.
#include <chrono>
#include <string>

#include <gtest/gtest.h>

#include "core/handin/map/ways.h"
#include "tests/core/handin/report_scene.h"

namespace leitstand::test {
namespace {

/// A map of 10 m x 6 m, free but for what is put into it.
class Hall {
public:
    Hall() {
        m_grid.origin = Eigen::Vector2d(-1.0, -3.0);
        m_grid.columns = 200, m_grid.rows = 120;
        m_grid.cells.assign(200U * 120U, {OccupancyGrid::State::Free, 1.0F});
    }
    void occupy(double x, double y, double toX, double toY) {
        for (double u = x; u <= toX + 1e-9; u += m_grid.cell) {
            for (double v = y; v <= toY + 1e-9; v += m_grid.cell) {
                const auto column = static_cast<int>((u - m_grid.origin.x()) / m_grid.cell + 1e-6),
                           row = static_cast<int>((v - m_grid.origin.y()) / m_grid.cell + 1e-6);
                m_grid.cells[static_cast<std::size_t>(row * m_grid.columns + column)].state =
                    OccupancyGrid::State::Occupied;
            }
        }
    }
    [[nodiscard]] const OccupancyGrid& map() const { return m_grid; }

private:
    OccupancyGrid m_grid;
};

RobotPath trail(std::string robot, const std::vector<Eigen::Vector3d>& corners) {
    RobotPath path{std::move(robot), {}};
    for (std::size_t i = 1; i < corners.size(); ++i) {
        for (int step = 0; step <= 100; ++step) {
            const Eigen::Vector3d point = corners[i - 1] + step / 100.0 * (corners[i] - corners[i - 1]);
            path.poses.push_back({Time{}, poseFrom(point, 0, 0, 0)});
        }
    }
    return path;
}

/// Two corridors along x, with a wall between them at y = 0 and a gap at its far end.
Hall twoCorridors() {
    Hall hall;
    hall.occupy(-1.0, 0.0, 6.5, 0.0);
    return hall;
}

TEST(WaysThroughTheMap, TheLastPieceGoesThroughNoWall) {
    // A victim behind the wall, nearer to the first corridor's trail than to the second one's.
    const std::vector<RobotPath> paths = {
        trail("kurt3d", {{0, -0.6, 0}, {7.5, -0.6, 0}, {7.5, 1.8, 0}, {2.0, 1.8, 0}})};
    const Way way = WayFinder(paths).to({3.0, 0.3, 0.1}, twoCorridors().map());
    EXPECT_TRUE(way.clear);
    ASSERT_GE(way.points.size(), 2u);
    EXPECT_NEAR(way.points[way.points.size() - 2].y(), 1.8, 0.01) << "from its own corridor";
    EXPECT_NEAR(way.lastPiece, 1.5, 0.16);
    EXPECT_GT(way.length, 13.0) << "around the wall";
}

TEST(WaysThroughTheMap, WhereNoStraightPieceIsFreeItIsToldSo) {
    const std::vector<RobotPath> paths = {trail("kurt3d", {{0, -0.6, 0}, {7.5, -0.6, 0}})};
    const Way way = WayFinder(paths).to({3.0, 1.0, 0.1}, twoCorridors().map());
    EXPECT_FALSE(way.clear);
    EXPECT_NEAR(way.lastPiece, 1.6, 0.16) << "the nearest place all the same";
    EXPECT_FALSE(WayFinder(paths).to({3.0, -1.0, 0.1}).clear) << "without a map nobody knows";
}

TEST(WaysThroughTheMap, WhatIsFoundIsInNobodysWay) {
    // What lies there is in the map itself, as is the wall that it leans on.
    Hall hall = twoCorridors();
    hall.occupy(2.8, -0.25, 3.2, -0.05);
    const std::vector<RobotPath> paths = {trail("kurt3d", {{0, -1.2, 0}, {7.5, -1.2, 0}})};
    const Way way = WayFinder(paths).to({3.0, -0.1, 0.1}, hall.map());
    EXPECT_TRUE(way.clear);
    EXPECT_NEAR(way.lastPiece, 1.1, 0.16);
}

TEST(WaysThroughTheMap, ARampOverAPassageDoesNotLeadToWhatLiesInThePassage) {
    // Kurt3D drives over a bridge 0.8 m above the passage in which the victim lies, the crawler into it.
    std::vector<Eigen::Vector3f> points;
    for (float x = -0.9F; x < 8.9F; x += 0.04F) {
        for (float y = -2.9F; y < 2.9F; y += 0.04F) {
            points.emplace_back(x, y, 0.0F);
            if (y > -0.5F && y < 0.5F) points.emplace_back(x, y, std::clamp(0.3F * x, 0.0F, 0.8F));
        }
    }
    const std::vector<ReportScan> scans = {scanOf(points, std::vector<Label>(points.size(), Label::Floor))};
    const std::vector<RobotPath> paths = {
        trail("kurt3d", {{-0.5, 0, 0}, {0, 0, 0}, {2.6667, 0, 0.8}, {7.0, 0, 0.8}}),
        trail("crawler", {{8.0, -2.5, 0}, {5.0, -2.5, 0}, {5.0, -1.0, 0}})};
    std::vector<Eigen::Vector3d> ground;
    for (const RobotPath& path : paths) {
        for (const PathPose& pose : path.poses) ground.push_back(pose.baseInMap.translation());
    }
    const FloorHeights floor = FloorHeights::of(scans, ground);
    const Way below = WayFinder(paths).to({5.0, -0.2, 0.1}, Hall().map(), floor);
    EXPECT_TRUE(below.clear);
    EXPECT_EQ(below.robot, "crawler");
    EXPECT_NEAR(below.lastPiece, 0.8, 0.16);
    const Way above = WayFinder(paths).to({5.0, -0.2, 1.0}, Hall().map(), floor);
    EXPECT_TRUE(above.clear);
    EXPECT_EQ(above.robot, "kurt3d") << "what lies on the bridge is reached over it";
}

}  // namespace
}  // namespace leitstand::test
