#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "core/cloud/search/kd_tree.h"
#include "tests/support/rooms.h"

namespace leitstand {
namespace {

using Points = std::vector<Eigen::Vector3f>;

/// Points near the surfaces of the room, where ICP asks for partners.
Points nearTheRoom(std::size_t count, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<float> off(0.0F, 0.15F);
    Points points = test::roomCloud(count, seed).points;
    for (auto& point : points) point += Eigen::Vector3f(off(random), off(random), off(random));
    return points;
}

TEST(BoundedSearch, TheApproximationFindsAPartnerWhereverThereIsOne) {
    const Points model = test::roomCloud(8'000, 1).points, queries = nearTheRoom(20'000, 2);
    for (const SimdLevel level : {SimdLevel::Plain, simdLevel()}) {
        const KdTree tree(model, level);
        for (const double epsilon : {0.5, 2.0}) {
            for (const float bound : {0.05F * 0.05F, 0.2F * 0.2F}) {
                for (const Eigen::Vector3f& query : queries) {
                    const Neighbour exact = tree.nearest(query, bound);
                    const Neighbour found = tree.nearestApproximate(query, epsilon, bound);
                    ASSERT_EQ(found.found(), exact.found());
                    if (!found.found()) continue;
                    ASSERT_LT(found.squaredDistance, bound);
                    ASSERT_LE(std::sqrt(double(found.squaredDistance)),
                              (1.0 + epsilon) * std::sqrt(double(exact.squaredDistance)) * (1.0 + 1e-6));
                }
            }
        }
    }
}

TEST(BoundedSearch, ThePlainPathAndTheProcessorsBestGiveTheSameAnswers) {
    const Points model = test::roomCloud(30'000, 3).points, queries = nearTheRoom(20'000, 4);
    const KdTree plain(model, SimdLevel::Plain), best(model);
    for (const double epsilon : {0.0, 0.5, 3.0}) {
        for (const float bound : {0.01F, 1.0F, KdTree::Unbounded}) {
            for (const Eigen::Vector3f& query : queries) {
                const Neighbour one = plain.nearestApproximate(query, epsilon, bound);
                const Neighbour other = best.nearestApproximate(query, epsilon, bound);
                ASSERT_EQ(one.found(), other.found());
                ASSERT_EQ(one.squaredDistance, other.squaredDistance);
            }
        }
    }
}

TEST(BoundedSearch, AForestOverPointsWithoutLabelsAnswersUnlabelledQueriesOnly) {
    PointCloud model = test::roomCloud(2'000, 5);
    model.labels.clear();
    const auto forest = makeSearch(model, SearchMethod::Forest);
    EXPECT_TRUE(forest->nearest({0, 0, 1}, Label::Unlabelled, KdTree::Unbounded).found());
    EXPECT_FALSE(forest->nearest({0, 0, 1}, Label::Wall, KdTree::Unbounded).found());
}

TEST(LongBoundedSearch, MoreThan2To24PointsKeepTheirIndices) {
    // A float cannot count so far. On a grid of 1 cm and 17 million places every point is its own neighbour.
    constexpr int Side = 258;
    Points model;
    model.reserve(static_cast<std::size_t>(Side) * Side * Side);
    for (int x = 0; x < Side; ++x) {
        for (int y = 0; y < Side; ++y) {
            for (int z = 0; z < Side; ++z)
                model.emplace_back(0.01F * float(x), 0.01F * float(y), 0.01F * float(z));
        }
    }
    ASSERT_GT(model.size(), std::size_t{1} << 24);
    const KdTree tree(model);
    for (std::size_t i = 0; i < model.size(); i += 99'991) {
        ASSERT_EQ(tree.nearest(model[i]).index, static_cast<std::int32_t>(i));
    }
    ASSERT_EQ(tree.nearest(model.back()).index, static_cast<std::int32_t>(model.size() - 1));
}

}  // namespace
}  // namespace leitstand
