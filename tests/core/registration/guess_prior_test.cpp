#include "core/registration/guess_prior.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "core/registration/icp.h"
#include "tests/support/rooms.h"

namespace leitstand {
namespace {

using test::moved;
using test::roomCloud;

/// A corridor along x, 2 m wide, as far as a scanner in it at @p from sees: two walls, floor and ceiling,
/// with noise.
/// @p pillars: of a side, 1 m apart, each 5 cm proud of its wall, 10 cm wide.
PointCloud corridor(double from, unsigned seed, bool pillars = false) {
    constexpr double Reach = 8.0, Noise = 0.01;
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> along(from - Reach, from + Reach), across(-1.0, 1.0),
        which(0.0, 4.0);
    std::normal_distribution<double> noise(0.0, Noise);
    PointCloud cloud;
    for (int i = 0; i < 8'000; ++i) {
        const double x = along(random), at = across(random);
        Eigen::Vector3d point, normal;
        switch (static_cast<int>(which(random))) {
            case 0:
                point = {x, 1.0, 1.2 + 1.2 * at};
                normal = -Eigen::Vector3d::UnitY();
                break;
            case 1:
                point = {x, -1.0, 1.2 + 1.2 * at};
                normal = Eigen::Vector3d::UnitY();
                break;
            case 2:
                point = {x, at, 0.0};
                normal = Eigen::Vector3d::UnitZ();
                break;
            default:
                point = {x, at, 2.4};
                normal = -Eigen::Vector3d::UnitZ();
        }
        if (pillars && std::abs(point.y()) == 1.0) {
            const double phase = x - std::floor(x);
            if (phase < 0.1) point.y() *= 0.95;
            if (i % 6 == 0) {  // their sides
                point.x() = std::floor(x) + (phase < 0.5 ? 0.0 : 0.1);
                point.y() *= 0.975 + 0.025 * at;
                normal = Eigen::Vector3d::UnitX() * (phase < 0.5 ? -1.0 : 1.0);
            }
        }
        cloud.points.push_back((point + noise(random) * normal).cast<float>());
        // As normals of noisy points are.
        cloud.normals.push_back(
            (normal + 0.05 * Eigen::Vector3d(noise(random), noise(random), noise(random)) / Noise)
                .normalized()
                .cast<float>());
    }
    return cloud;
}

GuessPrior odometry() {
    GuessPrior prior;
    prior.deviation << Eigen::Vector3d::Constant(0.013), Eigen::Vector3d::Constant(degrees(0.5));
    return prior;
}

IcpResult aligned(const PointCloud& target, const PointCloud& source, const Pose& guess,
                  std::optional<GuessPrior> prior) {
    IcpSettings settings;
    settings.maxDistances = {0.5, 0.25, 0.15};
    settings.prior = std::move(prior);
    return align(target, *makeSearch(target, SearchMethod::KdTree), source, guess, settings);
}

TEST(GuessPrior, HoldsACorridorsAxisWhereTheGuessHasItAndLeavesTheRestToTheWalls) {
    const Pose truth = poseFrom({0.30, 0, 0}, 0, 0, 0);
    for (unsigned seed = 1; seed <= 5; ++seed) {
        const PointCloud target = corridor(0.0, seed),
                         source = moved(truth.inverse(), corridor(0.3, seed + 10));
        const Pose guess = poseFrom({0.31, 0.05, 0.02}, degrees(0.5), degrees(-0.5), degrees(1.5));
        const IcpResult held = aligned(target, source, guess, odometry());
        EXPECT_GE(held.open, 1);
        EXPECT_NEAR(held.pose.translation().x(), 0.31, 0.01) << "as odometry has it";
        EXPECT_NEAR(held.pose.translation().y(), 0.0, 0.01);
        EXPECT_NEAR(held.pose.translation().z(), 0.0, 0.01);
        EXPECT_LT(angleBetween(held.pose, truth), degrees(0.3));
    }
}

TEST(GuessPrior, DoesNotPullAlongAxisAsPairsDo) {
    // The scan before saw the corridor 1 m behind: its far end pulls the pairs back.
    const Pose truth = poseFrom({1.0, 0, 0}, 0, 0, 0);
    const PointCloud target = corridor(0.0, 1), source = moved(truth.inverse(), corridor(1.0, 2));
    const double without = aligned(target, source, truth, std::nullopt).pose.translation().x();
    const double with = aligned(target, source, truth, odometry()).pose.translation().x();
    EXPECT_LT(std::abs(with - 1.0), 0.01);
    EXPECT_LE(std::abs(with - 1.0), std::abs(without - 1.0) + 0.002);
}

TEST(GuessPrior, GivesWayToWhatTheSurfacesKnow) {
    const Pose truth = poseFrom({0.30, 0, 0}, 0, 0, 0);
    const PointCloud target = corridor(0.0, 1, true), source = moved(truth.inverse(), corridor(0.3, 2, true));
    const Pose guess = poseFrom({0.26, 0.03, 0}, 0, 0, degrees(1));
    const IcpResult found = aligned(target, source, guess, odometry());
    EXPECT_NEAR(found.pose.translation().x(), 0.30, 0.015) << "pillars tell where along the corridor it is";
}

TEST(GuessPrior, HasNoSayInARoom) {
    const PointCloud room = roomCloud(8'000, 1);
    const Pose motion = poseFrom({0.15, -0.1, 0.02}, degrees(1), degrees(-1), degrees(4));
    const PointCloud source = moved(motion.inverse(), roomCloud(6'000, 2));
    const IcpResult with = aligned(room, source, Pose::Identity(), odometry());
    const IcpResult without = aligned(room, source, Pose::Identity(), std::nullopt);
    EXPECT_EQ(with.open, 0);
    EXPECT_EQ(with.pose.matrix(), without.pose.matrix()) << "to the bit";
}

}  // namespace
}  // namespace leitstand
