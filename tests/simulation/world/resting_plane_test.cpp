#include "robots/simulation/world/motion/resting_plane.h"

#include <algorithm>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>
#include <Eigen/LU>

namespace leitstand::simulation {
namespace {

/// The upper convex hull over a place is the highest of all mixtures of three points there.
double highestMixture(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector2d& place) {
    double best = -std::numeric_limits<double>::infinity();
    for (std::size_t a = 0; a < points.size(); ++a) {
        for (std::size_t b = a + 1; b < points.size(); ++b) {
            for (std::size_t c = b + 1; c < points.size(); ++c) {
                Eigen::Matrix3d system;
                system << points[a].x(), points[b].x(), points[c].x(), points[a].y(), points[b].y(),
                    points[c].y(), 1, 1, 1;
                if (std::abs(system.determinant()) < 1e-9) continue;
                const Eigen::Vector3d shares = system.inverse() * Eigen::Vector3d(place.x(), place.y(), 1);
                if (shares.minCoeff() < -1e-12) continue;
                best =
                    std::max(best, shares.dot(Eigen::Vector3d(points[a].z(), points[b].z(), points[c].z())));
            }
        }
    }
    return best;
}

TEST(RestingPlane, IsTheHullOverTheWeightForRandomGround) {
    std::mt19937_64 random(4);
    std::uniform_real_distribution<double> place(-0.2, 0.2), height(0.0, 0.1);
    for (int round = 0; round < 300; ++round) {
        std::vector<Eigen::Vector3d> points(12);
        for (Eigen::Vector3d& point : points) point = {place(random), place(random), height(random)};
        const Eigen::Vector2d weight(0.3 * place(random), 0.3 * place(random));
        const double expected = highestMixture(points, weight);
        const auto plane = restingPlane(points, weight);
        ASSERT_EQ(plane.has_value(), std::isfinite(expected));
        if (!plane) continue;
        EXPECT_NEAR(plane->at(weight), expected, 1e-6);
        double share = 0.0;
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_GE(plane->shares[i], -1e-8);
            share += plane->shares[i];
        }
        EXPECT_NEAR(share, 1.0, 1e-12);
        for (const Eigen::Vector3d& point : points) EXPECT_LE(point.z(), plane->at(point.head<2>()) + 1e-6);
    }
}

TEST(RestingPlane, IsNoneWhereTheWeightIsNotCarried) {
    const std::vector<Eigen::Vector3d> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    EXPECT_TRUE(restingPlane(points, {0.9, 0.9}));
    EXPECT_FALSE(restingPlane(points, {1.1, 0.5}));
    EXPECT_FALSE(restingPlane(std::vector<Eigen::Vector3d>(5, {1, 1, 0}), {1, 1}));
    EXPECT_FALSE(restingPlane({}, {0, 0}));
}

}  // namespace
}  // namespace leitstand::simulation
