#include "core/cloud/filters/normals.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "core/cloud/labels.h"
#include "tests/support/rooms.h"

namespace leitstand {
namespace {

using test::RoomScan;
using test::RoomSettings;
using test::scanRoom;

/// How far normals are from the truth [degrees].
struct Errors {
    double median = 0.0, ninetyFive = 0.0;
    double known = 0.0;  ///< fraction of the points with a normal
};

/// The wall, floor or ceiling direction of the room nearest to @p normal: rooms have no others.
double angleFromAxes(const Eigen::Vector3d& normal) {
    return inDegrees(std::acos(std::min(1.0, normal.cwiseAbs().maxCoeff())));
}

Errors errorsOf(const RoomScan& room, const std::vector<Eigen::Vector3f>& normals) {
    std::vector<double> angles;
    double looked = 0.0;
    for (std::size_t i = 0; i < normals.size(); ++i) {
        if (room.edgeDistances[i] <= 0.10F) continue;
        looked += 1.0;
        if (normals[i].isZero()) continue;
        angles.push_back(angleFromAxes(room.scan.sensorInOdom.linear() * normals[i].cast<double>()));
    }
    std::sort(angles.begin(), angles.end());
    return {angles[angles.size() / 2], angles[angles.size() * 95 / 100],
            static_cast<double>(angles.size()) / looked};
}

class NormalsOfRooms : public testing::TestWithParam<Sweep> {};

TEST_P(NormalsOfRooms, FromTheGridAreRightUnderNoise) {
    for (const double noise : {0.0, 0.005, 0.01, 0.02}) {
        RoomSettings settings;
        settings.sweep = GetParam();
        settings.rangeNoise = noise;
        settings.sensorInRoom = poseFrom({0.2, 0.1, 1.0}, degrees(5), degrees(-3), degrees(20));
        const RoomScan room = scanRoom(settings);
        const Errors errors = errorsOf(room, gridNormals(room.scan));
        std::printf("grid, noise %.3f m: median %.2f, 95 %% %.2f degrees, %.2f %% known\n", noise,
                    errors.median, errors.ninetyFive, 100.0 * errors.known);
        EXPECT_LT(errors.median, 0.1 + 250.0 * noise);
        EXPECT_LT(errors.ninetyFive, 0.5 + 600.0 * noise);
        EXPECT_GT(errors.known, 0.97);
    }
}

TEST_P(NormalsOfRooms, PointTowardsTheSensorAndHaveUnitLength) {
    RoomSettings settings;
    settings.sweep = GetParam();
    const RoomScan room = scanRoom(settings);
    const auto grid = gridNormals(room.scan), near = knnNormals(room.scan.points);
    for (std::size_t i = 0; i < grid.size(); ++i) {
        for (const Eigen::Vector3f& normal : {grid[i], near[i]}) {
            if (normal.isZero()) continue;
            ASSERT_NEAR(normal.norm(), 1.0F, 1e-5F);
            ASSERT_LE(normal.dot(room.scan.points[i]), 1e-5F);
        }
    }
}

TEST_P(NormalsOfRooms, FromNearestPointsAreRightUnderNoise) {
    RoomSettings settings;
    settings.sweep = GetParam();
    settings.rows = 113;
    settings.columns = 180;
    settings.rangeNoise = 0.005;
    const RoomScan room = scanRoom(settings);
    const Errors errors = errorsOf(room, knnNormals(room.scan.points));
    std::printf("nearest points, noise 0.005 m: median %.2f, 95 %% %.2f degrees, %.2f %% known\n",
                errors.median, errors.ninetyFive, 100.0 * errors.known);
    EXPECT_LT(errors.median, 4.0);
    EXPECT_GT(errors.known, 0.95);
}

INSTANTIATE_TEST_SUITE_P(Sweeps, NormalsOfRooms, testing::Values(Sweep::Tilting, Sweep::Yawing),
                         [](const auto& sweep) {
                             return sweep.param == Sweep::Tilting ? "Tilting" : "Yawing";
                         });

TEST_P(NormalsOfRooms, FromTheGridDoNotDependOnTheNumberOfThreads) {
    RoomSettings settings;
    settings.sweep = GetParam();
    const RoomScan room = scanRoom(settings);
    EXPECT_EQ(gridNormals(room.scan, 3), gridNormals(room.scan, 1));
}

TEST(Normals, DoNotReachAcrossADepthJump) {
    // A board 1 m in front of a wall: right up to its border, both have the normal of a plane.
    Scan scan;
    scan.rows = scan.columns = 101;
    for (int row = 0; row < scan.rows; ++row) {
        for (int column = 0; column < scan.columns; ++column) {
            const float y = 0.02F * static_cast<float>(50 - column), z = 0.02F * static_cast<float>(row - 50);
            const float distance = std::abs(column - 50) <= 10 && std::abs(row - 50) <= 10 ? 2.0F : 3.0F;
            scan.points.push_back(distance * Eigen::Vector3f(1, y, z));
        }
    }
    const auto normals = gridNormals(scan);
    for (const Eigen::Vector3f& normal : normals)
        ASSERT_LT((normal + Eigen::Vector3f::UnitX()).norm(), 1e-3F);
}

TEST(Normals, AreZeroWhereNoPlaneIsToBeTold) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const std::vector<Eigen::Vector3f> line = {{1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}};
    for (const auto& normal : knnNormals(line, 4)) EXPECT_TRUE(normal.isZero());
    const std::vector<Eigen::Vector3f> same(30, Eigen::Vector3f(1, 2, 3));
    for (const auto& normal : knnNormals(same)) EXPECT_TRUE(normal.isZero());
    const std::vector<Eigen::Vector3f> broken = {{1, 0, 0}, {1, 1, 0}, {1, 0, 1}, {nan, 0, 0}};
    const auto normals = knnNormals(broken, 4);
    EXPECT_LT((normals[0] + Eigen::Vector3f::UnitX()).norm(), 1e-5F);
    EXPECT_TRUE(normals[3].isZero());
    EXPECT_TRUE(knnNormals({}).empty());
}

TEST(Normals, OfNearestPointsDoNotDependOnTheNumberOfThreads) {
    const PointCloud cloud = test::roomCloud(5'000, 3);
    const auto one = knnNormals(cloud.points, 12, {0, 0, 1}, 1),
               two = knnNormals(cloud.points, 12, {0, 0, 1}, 2);
    EXPECT_EQ(one, two);
}

TEST(Normals, OfNearestPointsLookAtTheSensorGiven) {
    const PointCloud cloud = test::roomCloud(20'000, 4);
    const auto normals = knnNormals(cloud.points, 12, {0, 0, 1});
    std::size_t right = 0;
    for (std::size_t i = 0; i < cloud.size(); ++i) right += normals[i].dot(cloud.normals[i]) > 0.95F ? 1 : 0;
    EXPECT_GT(right, cloud.size() * 80 / 100);
}

}  // namespace
}  // namespace leitstand
