#include "core/registration/icp.h"

#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/rooms.h"

namespace leitstand {
namespace {

using test::moved;
using test::roomCloud;

std::vector<Minimizer> allMinimizers() {
    std::vector<Minimizer> all;
    for (const MinimizerRow& row : minimizers()) all.push_back(row.minimizer);
    return all;
}

IcpResult aligned(const PointCloud& target, const PointCloud& source, const IcpSettings& settings,
                  const Pose& guess = Pose::Identity()) {
    return align(target, *makeSearch(target, SearchMethod::KdTree), source, guess, settings);
}

TEST(Minimizers, HaveAWordForFilesWordsForOperatorsAndOneFunction) {
    std::set<std::string> keys;
    for (const MinimizerRow& row : minimizers()) {
        ASSERT_TRUE(row.key != nullptr && row.name != nullptr && row.hint != nullptr);
        EXPECT_TRUE(keys.insert(row.key).second) << row.key;
        EXPECT_NE(row.closedForm == nullptr, row.equations == nullptr) << row.key;
    }
}

class EveryMinimizer : public testing::TestWithParam<Minimizer> {};

TEST_P(EveryMinimizer, FindsAKnownMotionOfARoom) {
    const PointCloud room = roomCloud(8'000, 1);
    const Pose motion = poseFrom({0.15, -0.1, 0.02}, degrees(1), degrees(-1), degrees(4));
    IcpSettings settings;
    settings.minimizer = GetParam();
    const IcpResult result = aligned(room, moved(motion.inverse(), room), settings);
    EXPECT_TRUE(result.converged);
    EXPECT_EQ(result.stop, IcpStop::Converged);
    EXPECT_LT(distanceBetween(result.pose, motion), 1e-3);
    EXPECT_LT(angleBetween(result.pose, motion), 1e-3);
    EXPECT_GT(result.iterations, 1);
    EXPECT_LT(result.rms, 1e-3);
    EXPECT_GT(result.inlierRatio, 0.99);
    EXPECT_GT(result.overlap, 0.99);
    EXPECT_TRUE(result.certain());
}

TEST_P(EveryMinimizer, GivesTheSameResultOnAnyNumberOfThreads) {
    const PointCloud target = roomCloud(12'000, 1), source = roomCloud(10'000, 2);
    IcpSettings settings;
    settings.minimizer = GetParam();
    settings.maxIterations = 10;
    settings.threads = 1;
    const IcpResult one = aligned(target, source, settings, poseFrom({0.1, 0.05, 0}, 0, 0, degrees(3)));
    settings.threads = 3;
    const IcpResult three = aligned(target, source, settings, poseFrom({0.1, 0.05, 0}, 0, 0, degrees(3)));
    EXPECT_TRUE((one.pose.matrix().array() == three.pose.matrix().array()).all());
    EXPECT_EQ(one.iterations, three.iterations);
    EXPECT_EQ(one.rms, three.rms);
}

TEST_P(EveryMinimizer, NothingToPairIsToldNotCrashed) {
    const PointCloud room = roomCloud(2'000, 1);
    IcpSettings settings;
    settings.minimizer = GetParam();
    PointCloud empty;
    empty.normals.clear();
    for (const auto& [target, source] :
         {std::pair{room, empty}, std::pair{empty, room}, std::pair{empty, empty}}) {
        const IcpResult result = aligned(target, source, settings);
        EXPECT_FALSE(result.converged);
        EXPECT_EQ(result.stop, IcpStop::Degenerate);
        EXPECT_TRUE(result.pose.isApprox(Pose::Identity()));
    }
    const Pose away = poseFrom({500, 0, 0}, 0, 0, 0);
    const IcpResult result = aligned(room, room, settings, away);
    EXPECT_EQ(result.stop, IcpStop::Degenerate);
    EXPECT_TRUE(result.pose.isApprox(away)) << "it stays where it was put";
    EXPECT_EQ(result.overlap, 0.0);
}

INSTANTIATE_TEST_SUITE_P(All, EveryMinimizer, testing::ValuesIn(allMinimizers()));

TEST(Icp, WhatLiesBesideASurfaceCountsLittleWithAKernel) {
    const PointCloud room = roomCloud(8'000, 1);
    const Pose motion = poseFrom({0.02, -0.01, 0.01}, 0, 0, degrees(0.5));
    PointCloud source = moved(motion.inverse(), room);
    // A quarter of what faces the one end of the room hangs 4 cm before it, as a cupboard that stands there
    // now.
    for (std::size_t i = 0; i < source.size(); i += 2) {
        const Eigen::Vector3f& normal = room.normals[i];
        if (normal.x() > 0.9F && room.points[i].y() > 0.0F) source.points[i] += 0.04F * source.normals[i];
    }
    IcpSettings settings;
    settings.maxDistances = {0.2, 0.07};
    const IcpResult pulled = aligned(room, source, settings);
    settings.kernel = 3.0;
    const IcpResult held = aligned(room, source, settings);
    EXPECT_GT(distanceBetween(pulled.pose, motion), 2e-3);
    EXPECT_LT(distanceBetween(held.pose, motion), 0.3 * distanceBetween(pulled.pose, motion));
    EXPECT_LT(angleBetween(held.pose, motion), 0.3 * angleBetween(pulled.pose, motion));
    EXPECT_TRUE(held.converged);
}

TEST(Icp, AKernelChangesNothingWhereAllFits) {
    const PointCloud room = roomCloud(8'000, 1);
    const Pose motion = poseFrom({0.1, -0.05, 0.01}, 0, 0, degrees(2));
    IcpSettings settings;
    settings.maxDistances = {0.5, 0.2, 0.07};
    settings.kernel = 3.0;
    const IcpResult result = aligned(room, moved(motion.inverse(), room), settings);
    EXPECT_TRUE(result.converged);
    EXPECT_LT(distanceBetween(result.pose, motion), 1e-4);
}

TEST(Icp, StartsFarAwayNeedASchedule) {
    const PointCloud target = roomCloud(6'000, 1), source = roomCloud(6'000, 2);
    const Pose guess = poseFrom({0.8, -0.5, 0.1}, 0, 0, degrees(15));
    IcpSettings settings;
    settings.maxDistances = {1.5, 0.5, 0.2};
    const IcpResult result = aligned(target, source, settings, guess);
    EXPECT_TRUE(result.converged);
    EXPECT_LT(distanceBetween(result.pose, Pose::Identity()), 0.02);
    EXPECT_LT(inDegrees(angleBetween(result.pose, Pose::Identity())), 0.3);
}

TEST(Icp, AStageWithoutPairsLeavesWhatTheOnesBeforeFound) {
    const PointCloud target = roomCloud(8'000, 1), source = roomCloud(8'000, 2);
    IcpSettings settings;
    settings.maxDistances = {0.5, 1e-7};
    const IcpResult result =
        aligned(target, source, settings, poseFrom({0.15, -0.1, 0.02}, 0, 0, degrees(4)));
    EXPECT_TRUE(result.converged);
    EXPECT_EQ(result.stop, IcpStop::Converged);
    EXPECT_LT(distanceBetween(result.pose, Pose::Identity()), 0.02);
    EXPECT_GT(result.inlierRatio, 0.9) << "judged by the last stage that had pairs";
}

TEST(Icp, StopsAtTheIterationLimitAndSaysSo) {
    const PointCloud room = roomCloud(4'000, 1);
    IcpSettings settings;
    settings.minimizer = Minimizer::Svd;
    settings.maxIterations = 3;
    const IcpResult result = aligned(room, room, settings, poseFrom({0.3, 0.2, 0}, 0, 0, degrees(5)));
    EXPECT_EQ(result.iterations, 3);
    EXPECT_EQ(result.stop, IcpStop::IterationLimit);
    EXPECT_FALSE(result.converged);
}

TEST(Icp, CancelsBetweenIterations) {
    const PointCloud room = roomCloud(4'000, 1);
    std::stop_source stop;
    stop.request_stop();
    const IcpResult result = align(room, *makeSearch(room, SearchMethod::KdTree), room,
                                   poseFrom({0.3, 0, 0}, 0, 0, 0), {}, {{}, stop.get_token()});
    EXPECT_EQ(result.stop, IcpStop::Cancelled);
    EXPECT_EQ(result.iterations, 0);
    EXPECT_FALSE(result.converged);
}

TEST(Icp, MinimisersThatNeedNormalsEndAtOnceWithoutThem) {
    const PointCloud whole = roomCloud(3'000, 1);
    PointCloud bare = whole;
    bare.normals.clear();
    for (const MinimizerRow& row : minimizers()) {
        IcpSettings settings;
        settings.minimizer = row.minimizer;
        const bool ofTarget = row.equations != nullptr;
        EXPECT_EQ(aligned(bare, whole, settings).stop == IcpStop::Degenerate, ofTarget) << row.key;
        EXPECT_EQ(aligned(whole, bare, settings).stop == IcpStop::Degenerate, row.sourceNormals) << row.key;
    }
}

TEST(Icp, PointsWithoutANormalDoNoHarm) {
    PointCloud target = roomCloud(6'000, 1), source = roomCloud(6'000, 2);
    for (std::size_t i = 0; i < target.size(); i += 2) target.normals[i].setZero();
    for (std::size_t i = 0; i < source.size(); i += 3) source.normals[i].setZero();
    const IcpResult result = aligned(target, source, {}, poseFrom({0.1, 0.05, 0}, 0, 0, degrees(3)));
    EXPECT_TRUE(result.converged);
    EXPECT_LT(distanceBetween(result.pose, Pose::Identity()), 0.02);
}

TEST(Icp, AllSearchMethodsEndAtTheSamePlace) {
    const PointCloud target = roomCloud(6'000, 1), source = roomCloud(3'000, 2);
    for (const SearchMethod method :
         {SearchMethod::BruteForce, SearchMethod::KdTree, SearchMethod::Approximate, SearchMethod::Forest}) {
        const auto search = makeSearch(target, method, 0.5);
        const IcpResult result = align(target, *search, source, poseFrom({0.1, 0.05, 0}, 0, 0, degrees(3)));
        EXPECT_TRUE(result.converged) << int(method);
        EXPECT_LT(distanceBetween(result.pose, Pose::Identity()), 0.02) << int(method);
    }
}

/// A tunnel along x of @p length: floor, walls and ceiling, but nothing that tells where along it one is.
PointCloud tunnel(double length) {
    PointCloud cloud;
    for (double x = 0; x < length; x += 0.05) {
        for (double s = -1.0; s < 1.0; s += 0.05) {
            const auto add = [&](double y, double z, const Eigen::Vector3f& normal) {
                cloud.points.push_back(Eigen::Vector3d(x, y, z).cast<float>());
                cloud.normals.push_back(normal);
            };
            add(s, 0, Eigen::Vector3f::UnitZ());
            add(s, 2, -Eigen::Vector3f::UnitZ());
            add(-1, s + 1, Eigen::Vector3f::UnitY());
            add(1, s + 1, -Eigen::Vector3f::UnitY());
        }
    }
    return cloud;
}

TEST(Icp, ACorridorIsUncertainAlongItsAxis) {
    const PointCloud corridor = tunnel(6.0);
    IcpSettings settings;
    settings.minimizer = Minimizer::Svd;
    const IcpResult result = aligned(corridor, corridor, settings);
    EXPECT_LT(result.certainty, IcpResult::UncertainBelow);
    EXPECT_FALSE(result.certain());
    EXPECT_GT(std::abs(result.weakest[0]), 0.99) << "the open direction is x";
    const PointCloud room = roomCloud(5'000, 1);
    EXPECT_GT(aligned(room, room, settings).certainty, 3 * IcpResult::UncertainBelow);
}

/// Adds a wall of 4 x 2 m across x at @p x [m], seen from where @p normal points to.
void addWall(PointCloud& cloud, double x, const Eigen::Vector3f& normal) {
    for (double y = -2.0; y < 2.0; y += 0.05) {
        for (double z = 0.0; z < 2.0; z += 0.05) {
            cloud.points.push_back(Eigen::Vector3d(x, y, z).cast<float>());
            cloud.normals.push_back(normal);
        }
    }
}

TEST(Icp, TheOtherSideOfAWallIsAnotherSurface) {
    // What is known of a room is what one saw through its door, and the far side of its wall, from next door.
    PointCloud known = tunnel(1.0), seen = tunnel(1.0);
    addWall(known, 3.0, Eigen::Vector3f::UnitX());
    addWall(seen, 2.9, -Eigen::Vector3f::UnitX());
    for (PointCloud* cloud : {&known, &seen}) {
        for (double y = -0.5; y < 0.5; y += 0.05) {
            cloud->points.push_back(Eigen::Vector3d(0.0, y, 1.0).cast<float>());
            cloud->normals.push_back(Eigen::Vector3f::UnitX());
        }
    }
    IcpSettings settings;
    settings.maxDistances = {0.5, 0.25, 0.15, 0.07};
    EXPECT_GT(distanceBetween(aligned(known, seen, settings).pose, Pose::Identity()), 0.05);
    settings.facing = true;
    const IcpResult result = aligned(known, seen, settings);
    EXPECT_LT(distanceBetween(result.pose, Pose::Identity()), 0.01);
    EXPECT_LT(result.overlap, 0.7) << "the wall is new";
    PointCloud without = known;
    without.normals.clear();
    settings.minimizer = Minimizer::Svd;
    EXPECT_GT(aligned(without, seen, settings).overlap, 0.9) << "nobody knows which side it is";
}

}  // namespace
}  // namespace leitstand
