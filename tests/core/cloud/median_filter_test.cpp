#include "core/cloud/filters/median_filter.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include <gtest/gtest.h>

#include "tests/support/rooms.h"

namespace leitstand {
namespace {

/// A raw scan of a wall 2 m ahead, half a degree from shot to shot.
Scan wall(int rows, int columns) {
    Scan scan;
    scan.rows = rows;
    scan.columns = columns;
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const double across = std::tan(degrees(0.5) * (column - columns / 2));
            const double up = std::tan(degrees(0.5) * (row - rows / 2));
            scan.points.push_back((2.0 * Eigen::Vector3d(1, across, up)).cast<float>());
        }
    }
    return scan;
}

/// Of horizontal surfaces; zero for others.
std::vector<Eigen::Vector3f> levelNormals(const test::RoomScan& room) {
    std::vector<Eigen::Vector3f> normals(room.scan.points.size(), Eigen::Vector3f::Zero());
    for (std::size_t i = 0; i < normals.size(); ++i) {
        if (room.trueLabels[i] == Label::Floor) normals[i] = Eigen::Vector3f::UnitZ();
        if (room.trueLabels[i] == Label::Ceiling) normals[i] = -Eigen::Vector3f::UnitZ();
    }
    return normals;
}

TEST(MedianFilter, LeavesAboutATenthOfARoomWithLabelsAndNormals) {
    for (const Sweep sweep : {Sweep::Tilting, Sweep::Yawing}) {
        test::RoomSettings settings;
        settings.sweep = sweep;
        test::RoomScan room = test::scanRoom(settings);
        room.scan.labels = room.trueLabels;
        const PointCloud cloud = medianReduced(room.scan, levelNormals(room));
        ASSERT_EQ(cloud.labels.size(), cloud.size());
        ASSERT_EQ(cloud.normals.size(), cloud.size());
        const double left = static_cast<double>(cloud.size()) / static_cast<double>(room.scan.points.size());
        std::printf("%s: %.1f %% of the points left\n", sweep == Sweep::Tilting ? "tilting" : "yawing",
                    100 * left);
        EXPECT_GT(left, 0.05);
        EXPECT_LT(left, 0.18);
        std::size_t floor = 0;
        for (std::size_t i = 0; i < cloud.size(); ++i) {
            ASSERT_TRUE(cloud.points[i].allFinite());
            if (cloud.labels[i] != Label::Floor || cloud.points[i].z() > -0.9F) continue;
            ++floor;
            EXPECT_GT(cloud.normals[i].z(), 0.6F);
        }
        EXPECT_GT(floor, 300U);
    }
}

TEST(MedianFilter, StaysOnTheSurfacesOfARoom) {
    test::RoomSettings settings;
    settings.furnished = false;
    const test::RoomScan room = test::scanRoom(settings);
    const PointCloud cloud = medianReduced(room.scan, {});
    double squares = 0.0;
    for (const auto& point : cloud.points) {
        const double distance =
            std::min({std::abs(4.0 - std::abs(point.x())), std::abs(3.0 - std::abs(point.y())),
                      std::abs(point.z() + 1.0), std::abs(1.6 - point.z())});
        squares += distance * distance;
        EXPECT_LT(distance, 0.08);
    }
    EXPECT_LT(std::sqrt(squares / static_cast<double>(cloud.size())), 0.01);
}

TEST(MedianFilter, AnOutlierBecomesTheMedianOfItsNeighbours) {
    for (const float spike : {0.5F, 5.0F}) {
        Scan scan = wall(1, 61);
        scan.labels.assign(61, Label::Wall);
        scan.points[30] *= spike;
        scan.labels[30] = Label::Ceiling;
        std::vector<Eigen::Vector3f> normals(61, -Eigen::Vector3f::UnitX());
        normals[30] = Eigen::Vector3f::UnitZ();
        const PointCloud cloud = medianReduced(scan, normals);
        ASSERT_GT(cloud.size(), 5U);
        for (std::size_t i = 0; i < cloud.size(); ++i) {
            EXPECT_NEAR(cloud.points[i].x(), 2.0F, 0.01F);
            EXPECT_EQ(cloud.labels[i], Label::Wall);
            EXPECT_NEAR(cloud.normals[i].x(), -1.0F, 1e-5F);
        }
    }
}

TEST(MedianFilter, ADepthEdgeStaysWhereItIs) {
    Scan scan = wall(1, 60);
    for (std::size_t i = 30; i < 60; ++i) scan.points[i] *= 2.0F;
    for (const Eigen::Vector3f& point : medianReduced(scan, {}).points) {
        EXPECT_TRUE(std::abs(point.x() - 2.0F) < 1e-3F || std::abs(point.x() - 4.0F) < 1e-3F) << point.x();
    }
}

TEST(MedianFilter, JoinsOnlyWhatIsCloseTogether) {
    MedianFilterSettings settings;
    settings.joinDistance = 0.01;  // shots are 17 mm apart
    EXPECT_EQ(medianReduced(wall(1, 40), {}, settings).size(), 40U);
    settings.joinDistance = 0.05;
    settings.longestRun = 0.10;  // 0.69 m of wall
    const std::size_t size = medianReduced(wall(1, 40), {}, settings).size();
    EXPECT_GE(size, 6U);
    EXPECT_LE(size, 9U);
    EXPECT_LT(medianReduced(wall(6, 40), {}, settings).size(), 3 * size);
}

TEST(MedianFilter, LeavesOutWhatIsOutOfRange) {
    constexpr float None = std::numeric_limits<float>::quiet_NaN();
    Scan scan = wall(3, 20);
    for (std::size_t i = 0; i < 20; ++i) {
        scan.points[i] *= 0.1F;
        scan.points[20 + i] *= 20.0F;
        scan.points[40 + i].setConstant(None);
    }
    EXPECT_EQ(medianReduced(scan, {}).size(), 0U);
    scan.rows = scan.columns = 0;
    scan.points[7] = {3, 0, 0};
    EXPECT_EQ(medianReduced(scan, {}).size(), 1U);
}

}  // namespace
}  // namespace leitstand
