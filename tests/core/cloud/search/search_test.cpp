#include "core/cloud/search/search.h"

#include <cstdio>
#include <limits>
#include <random>
#include <thread>

#include <gtest/gtest.h>

#include "core/cloud/search/kd_tree.h"
#include "tests/support/rooms.h"

namespace leitstand {
namespace {

constexpr float Unbounded = std::numeric_limits<float>::infinity();

using Points = std::vector<Eigen::Vector3f>;

Points randomPoints(std::size_t count, unsigned seed, float size = 10.0F) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> within(-size, size);
    Points points;
    for (std::size_t i = 0; i < count; ++i)
        points.emplace_back(within(random), within(random), within(random));
    return points;
}

/// Nearest of @p model by looking at every point.
Neighbour bruteForce(const Points& model, const Eigen::Vector3f& query, float bound = Unbounded) {
    Neighbour best{-1, bound};
    for (std::size_t i = 0; i < model.size(); ++i) {
        const float distance = detail::squaredDistance(query, model[i]);
        if (distance < best.squaredDistance) best = {static_cast<std::int32_t>(i), distance};
    }
    return best;
}

/// Surfaces, as scanners see them; @p count points.
Points roomPoints(std::size_t count, unsigned seed) {
    return test::roomCloud(count, seed).points;
}

class OnBothPaths : public testing::TestWithParam<SimdLevel> {
protected:
    void SetUp() override {
        if (GetParam() > simdLevel()) GTEST_SKIP() << "SKIPPED: this processor has no AVX2";
    }
};

TEST_P(OnBothPaths, TheKdTreeIsExact) {
    for (const Points& model :
         {randomPoints(3'000, 1), roomPoints(5'000, 2), randomPoints(97, 3), randomPoints(1, 4)}) {
        const KdTree tree(model, GetParam());
        for (const Points& queries : {randomPoints(700, 5, 14.0F), model}) {
            for (std::size_t i = 0; i < std::min<std::size_t>(queries.size(), 700); ++i) {
                const Neighbour found = tree.nearest(queries[i]), expected = bruteForce(model, queries[i]);
                ASSERT_TRUE(found.found());
                ASSERT_EQ(found.squaredDistance, expected.squaredDistance);
                ASSERT_EQ(detail::squaredDistance(queries[i], model[static_cast<std::size_t>(found.index)]),
                          expected.squaredDistance);
            }
        }
    }
}

TEST_P(OnBothPaths, BoundsAreStrict) {
    const Points model = roomPoints(4'000, 1);
    const KdTree tree(model, GetParam());
    for (const Eigen::Vector3f& query : randomPoints(500, 2, 5.0F)) {
        const float distance = bruteForce(model, query).squaredDistance;
        EXPECT_FALSE(tree.nearest(query, distance).found()) << "not below the bound";
        EXPECT_FALSE(tree.nearest(query, 0.5F * distance).found());
        EXPECT_EQ(tree.nearest(query, std::nextafter(distance, Unbounded)).squaredDistance, distance);
        EXPECT_FALSE(tree.nearest(query, 0.0F).found());
    }
}

TEST_P(OnBothPaths, TheApproximationKeepsItsPromiseOnAMillionQueries) {
    const Points model = roomPoints(20'000, 1);
    const KdTree tree(model, GetParam());
    std::mt19937 random(2);
    std::uniform_real_distribution<float> within(-5.0F, 5.0F);
    double farthest = 1.0;
    std::size_t inexact = 0;
    for (const double epsilon : {0.1, 0.5, 2.0, 10.0}) {
        for (int i = 0; i < 250'000; ++i) {
            const Eigen::Vector3f query(within(random), within(random), within(random));
            const Neighbour exact = tree.nearest(query), found = tree.nearestApproximate(query, epsilon);
            ASSERT_TRUE(found.found());
            const double ratio = std::sqrt(double(found.squaredDistance) / double(exact.squaredDistance));
            ASSERT_LE(ratio, (1.0 + epsilon) * (1.0 + 1e-6));
            farthest = std::max(farthest, ratio);
            inexact += found.squaredDistance > exact.squaredDistance ? 1 : 0;
        }
    }
    std::printf("[          ] %.2f %% of a million are not exact, the worst is %.2f times as far\n",
                double(inexact) / 1e4, farthest);
    EXPECT_GT(inexact, 0u) << "an approximate search that never approximates saves nothing";
}

TEST_P(OnBothPaths, DegenerateModels) {
    const Points spot(500, Eigen::Vector3f(1, 2, 3));
    const KdTree spotTree(spot, GetParam());
    EXPECT_EQ(spotTree.nearest({1, 2, 4}).squaredDistance, 1.0F);
    Points line, huge = randomPoints(2'000, 6, 1e18F);
    for (int i = 0; i < 1'000; ++i) line.emplace_back(0.1F * float(i), 0.0F, 0.0F);
    const KdTree lineTree(line, GetParam()), hugeTree(huge, GetParam());
    for (const Eigen::Vector3f& query : randomPoints(300, 7, 50.0F)) {
        ASSERT_EQ(lineTree.nearest(query).squaredDistance, bruteForce(line, query).squaredDistance);
    }
    for (const Eigen::Vector3f& query : randomPoints(300, 8, 1e18F)) {
        ASSERT_EQ(hugeTree.nearest(query).squaredDistance, bruteForce(huge, query).squaredDistance);
    }
    const KdTree empty(Points{}, GetParam());
    EXPECT_FALSE(empty.nearest({0, 0, 0}).found());
    EXPECT_EQ(empty.size(), 0u);
}

TEST_P(OnBothPaths, PointsThatAreNotFiniteAreLeftOut) {
    Points model = randomPoints(200, 1);
    for (std::size_t i = 0; i < model.size(); i += 2) model[i].y() = std::numeric_limits<float>::quiet_NaN();
    model[1].x() = Unbounded;
    const KdTree tree(model, GetParam());
    EXPECT_EQ(tree.size(), 99u);
    for (const Eigen::Vector3f& query : randomPoints(200, 2)) {
        const Neighbour found = tree.nearest(query);
        ASSERT_EQ(found.index % 2, 1);
        ASSERT_EQ(found.squaredDistance, bruteForce(model, query).squaredDistance);
    }
}

INSTANTIATE_TEST_SUITE_P(All, OnBothPaths, testing::Values(SimdLevel::Plain, SimdLevel::Avx2),
                         [](const auto& info) { return info.param == SimdLevel::Plain ? "Plain" : "Avx2"; });

TEST(KdTree, FindsTheKNearestInOrderAndAllWithinARadius) {
    const Points model = roomPoints(3'000, 1);
    const KdTree tree(model);
    std::vector<Neighbour> found;
    for (const Eigen::Vector3f& query : randomPoints(100, 2, 4.0F)) {
        std::vector<float> distances;
        for (const Eigen::Vector3f& point : model) distances.push_back(detail::squaredDistance(query, point));
        std::sort(distances.begin(), distances.end());
        tree.kNearest(query, 20, found);
        ASSERT_EQ(found.size(), 20u);
        for (std::size_t i = 0; i < found.size(); ++i) ASSERT_EQ(found[i].squaredDistance, distances[i]);
        tree.withinRadius(query, 1.0F, found);
        EXPECT_EQ(found.size(),
                  static_cast<std::size_t>(std::lower_bound(distances.begin(), distances.end(), 1.0F) -
                                           distances.begin()));
    }
    tree.kNearest({0, 0, 0}, 5'000, found);
    EXPECT_EQ(found.size(), model.size()) << "all there are";
}

TEST(KdTree, TakesAtMost20BytesAPoint) {
    for (const Points& model : {roomPoints(78'000, 1), randomPoints(100'000, 2)}) {
        const KdTree tree(model);
        std::printf("[          ] %.1f bytes a point\n", double(tree.memory()) / double(model.size()));
        EXPECT_LE(double(tree.memory()) / double(model.size()), 20.0);
    }
}

TEST(Search, EveryMethodFindsWhatItPromises) {
    const PointCloud model = test::roomCloud(4'000, 1);
    for (const SearchMethod method :
         {SearchMethod::BruteForce, SearchMethod::KdTree, SearchMethod::Approximate}) {
        const double epsilon = method == SearchMethod::Approximate ? 0.5 : 0.0;
        const auto search = makeSearch(model, method, epsilon);
        for (const Eigen::Vector3f& query : randomPoints(300, 2, 4.0F)) {
            const Neighbour found = search->nearest(query, Label::Wall, Unbounded);
            const float exact = bruteForce(model.points, query).squaredDistance;
            ASSERT_TRUE(found.found());
            ASSERT_LE(std::sqrt(found.squaredDistance), (1.0 + epsilon) * std::sqrt(exact) * (1.0 + 1e-6));
            EXPECT_FALSE(search->nearest(query, Label::Wall, 0.0F).found());
        }
    }
}

TEST(Search, InTheForestPointsFindOnlyTheirOwnKind) {
    const PointCloud model = test::roomCloud(6'000, 1);
    const auto forest = makeSearch(model, SearchMethod::Forest, 0.0);
    for (const Label label : {Label::Floor, Label::Wall, Label::Ceiling}) {
        Points own;
        for (std::size_t i = 0; i < model.size(); ++i) {
            if (model.labels[i] == label) own.push_back(model.points[i]);
        }
        ASSERT_FALSE(own.empty());
        for (const Eigen::Vector3f& query : randomPoints(200, 3, 4.0F)) {
            const Neighbour found = forest->nearest(query, label, Unbounded);
            ASSERT_TRUE(found.found());
            EXPECT_EQ(model.labels[static_cast<std::size_t>(found.index)], label);
            EXPECT_EQ(found.squaredDistance, bruteForce(own, query).squaredDistance);
        }
    }
    EXPECT_FALSE(forest->nearest({0, 0, 0}, Label::Unlabelled, Unbounded).found()) << "this model has none";
}

TEST(Search, AnEmptyModelFindsNothing) {
    const PointCloud empty;
    for (const SearchMethod method :
         {SearchMethod::BruteForce, SearchMethod::KdTree, SearchMethod::Approximate, SearchMethod::Forest}) {
        EXPECT_FALSE(makeSearch(empty, method, 0.5)->nearest({0, 0, 0}, Label::Floor, Unbounded).found());
    }
}

TEST(Search, QueriesFromManyThreadsAgree) {
    const PointCloud model = test::roomCloud(20'000, 1);
    const auto search = makeSearch(model, SearchMethod::KdTree);
    const Points queries = randomPoints(5'000, 2, 4.0F);
    std::vector<std::vector<Neighbour>> results(4);
    {
        std::vector<std::jthread> threads;
        for (auto& result : results) {
            threads.emplace_back([&] {
                for (const Eigen::Vector3f& query : queries)
                    result.push_back(search->nearest(query, Label::Floor, Unbounded));
            });
        }
    }
    for (const auto& result : results) {
        for (std::size_t i = 0; i < queries.size(); ++i) ASSERT_EQ(result[i].index, results[0][i].index);
    }
}

}  // namespace
}  // namespace leitstand
