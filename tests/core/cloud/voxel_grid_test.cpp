#include "core/cloud/filters/voxel_grid.h"

#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/support/rooms.h"

namespace leitstand {
namespace {

using Cube = std::array<long, 3>;

Cube cubeOf(const Eigen::Vector3f& point, double edge) {
    const auto index = [edge](float value) { return std::lround(std::floor(value / edge)); };
    return {index(point.x()), index(point.y()), index(point.z())};
}

std::map<Cube, std::vector<std::size_t>> pointsOfCubes(const PointCloud& cloud, double edge) {
    std::map<Cube, std::vector<std::size_t>> result;
    for (std::size_t i = 0; i < cloud.size(); ++i) result[cubeOf(cloud.points[i], edge)].push_back(i);
    return result;
}

Eigen::Vector3d centroidOf(const PointCloud& cloud, const std::vector<std::size_t>& points) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const std::size_t i : points) sum += cloud.points[i].cast<double>();
    return sum / static_cast<double>(points.size());
}

/// A room whose surfaces lie inside cubes, not on their borders, where rounding would decide.
PointCloud room() {
    return test::moved(poseFrom({0.531, 0.217, 0.023}, 0.1, 0.2, 0.3), test::roomCloud(30'000, 3));
}

TEST(VoxelGrid, BeginsWhereItIsSaidTo) {
    PointCloud cloud;
    cloud.points = {{0.02F, 0, 0}, {0.08F, 0, 0}, {0.13F, 0, 0}};
    EXPECT_EQ(voxelGrid(cloud, 0.1).size(), 2U);
    const PointCloud shifted = voxelGrid(cloud, 0.1, VoxelPoint::Centroid, {0.05, 0, 0});
    ASSERT_EQ(shifted.size(), 2U);
    EXPECT_FLOAT_EQ(shifted.points[0].x(), 0.02F);
    EXPECT_FLOAT_EQ(shifted.points[1].x(), 0.105F);
}

TEST(VoxelGrid, EachScanHasAnOriginOfItsOwn) {
    constexpr double Edge = 0.1;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    constexpr int Count = 200;
    for (int i = 0; i < Count; ++i) {
        std::vector<Eigen::Vector3f> points = {{1.0F + 0.01F * static_cast<float>(i), 2, 3}};
        points.insert(points.begin(), Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN()));
        const Eigen::Vector3d origin = ownGridOrigin(points, Edge);
        EXPECT_GE(origin.minCoeff(), 0.0);
        EXPECT_LT(origin.maxCoeff(), Edge);
        EXPECT_EQ(origin, ownGridOrigin(points, Edge)) << "the same for the same scan";
        sum += origin;
    }
    EXPECT_TRUE((sum / Count).isApprox(Eigen::Vector3d::Constant(0.5 * Edge), 0.15)) << sum / Count;
    EXPECT_TRUE(ownGridOrigin({}, Edge).allFinite());
}

TEST(VoxelGrid, KeepsTheRealPointNearestToEachCentroid) {
    constexpr double Edge = 0.25;
    const PointCloud cloud = room();
    const auto cubes = pointsOfCubes(cloud, Edge);

    const PointCloud reduced = voxelGrid(cloud, Edge);

    ASSERT_EQ(reduced.size(), cubes.size());
    ASSERT_EQ(reduced.labels.size(), cubes.size());
    ASSERT_EQ(reduced.normals.size(), cubes.size());
    for (std::size_t i = 0; i < reduced.size(); ++i) {
        const auto& inside = cubes.at(cubeOf(reduced.points[i], Edge));
        const Eigen::Vector3d centroid = centroidOf(cloud, inside);
        const double kept = (reduced.points[i].cast<double>() - centroid).norm();
        bool real = false;
        for (const std::size_t j : inside) {
            EXPECT_LE(kept, (cloud.points[j].cast<double>() - centroid).norm() + 1e-5);
            real = real || (cloud.points[j] == reduced.points[i] && cloud.labels[j] == reduced.labels[i] &&
                            cloud.normals[j] == reduced.normals[i]);
        }
        EXPECT_TRUE(real);
    }
}

TEST(VoxelGrid, CentroidsCarryTheCommonestLabelAndTheMeanNormal) {
    constexpr double Edge = 0.25;
    const PointCloud cloud = room();
    const auto cubes = pointsOfCubes(cloud, Edge);

    const PointCloud reduced = voxelGrid(cloud, Edge, VoxelPoint::Centroid);

    ASSERT_EQ(reduced.size(), cubes.size());
    std::size_t mixed = 0;
    for (std::size_t i = 0; i < reduced.size(); ++i) {
        const auto& inside = cubes.at(cubeOf(reduced.points[i], Edge));
        EXPECT_LT((reduced.points[i].cast<double>() - centroidOf(cloud, inside)).norm(), 1e-5);
        std::array<std::size_t, LabelCount> counts{};
        Eigen::Vector3f normal = Eigen::Vector3f::Zero();
        for (const std::size_t j : inside) {
            ++counts[static_cast<std::size_t>(cloud.labels[j])];
            normal += cloud.normals[j];
        }
        for (const std::size_t count : counts) {
            EXPECT_GE(counts[static_cast<std::size_t>(reduced.labels[i])], count);
        }
        EXPECT_LT((reduced.normals[i] - normal.normalized()).norm(), 1e-3);
        mixed += counts[static_cast<std::size_t>(reduced.labels[i])] < inside.size();
    }
    EXPECT_GT(mixed, 50U);  // edges of the room: else nothing was tested
}

TEST(VoxelGrid, LeavesOutWhatNoVoxelCanHold) {
    constexpr float None = std::numeric_limits<float>::quiet_NaN();
    constexpr float Infinite = std::numeric_limits<float>::infinity();
    constexpr float Huge = std::numeric_limits<float>::max();
    PointCloud cloud;
    cloud.points = {{1, 1, 1},        {None, 1, 1}, {1, Infinite, 1},      {1, 1, -Infinite},
                    {-Huge, Huge, 0}, {2e5F, 0, 0}, {-1.04e5F, 1e5F, 1e5F}};
    for (const VoxelPoint kept : {VoxelPoint::Nearest, VoxelPoint::Centroid}) {
        const PointCloud reduced = voxelGrid(cloud, 0.1, kept);
        ASSERT_EQ(reduced.size(), 2U);
        EXPECT_EQ(reduced.points[0], cloud.points[0]);
        EXPECT_EQ(reduced.points[1], cloud.points[6]);
    }
    EXPECT_EQ(voxelGrid(PointCloud{}, 0.1).size(), 0U);
    EXPECT_THROW((void)voxelGrid(cloud, 0.0), std::invalid_argument);
    EXPECT_THROW((void)voxelGrid(cloud, None), std::invalid_argument);
}

TEST(VoxelGrid, ManyCubesAreToldApart) {
    PointCloud cloud;
    for (int x = -40; x < 40; ++x) {
        for (int y = -40; y < 40; ++y) {
            for (int z = -10; z < 10; ++z) {
                cloud.points.emplace_back(Eigen::Vector3i(x, y, z).cast<float>() * 100.0F +
                                          Eigen::Vector3f::Constant(0.5F));
            }
        }
    }
    EXPECT_EQ(voxelGrid(cloud, 1.0).points, cloud.points);
}

}  // namespace
}  // namespace leitstand
