#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include <benchmark/benchmark.h>
#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <nanoflann.hpp>

#include "benchmarks/hall.h"
#include "core/cloud/search/search.h"

// Model: scan000. Queries: the points of scan001 in scan order, moved by the odometry. An item is a query or
// a model point, so that items_per_second tells the time of one.
namespace leitstand::benchmarks {
namespace {

struct NanoflannCloud {
    const std::vector<Eigen::Vector3f>& points;

    [[nodiscard]] std::size_t kdtree_get_point_count() const { return points.size(); }
    [[nodiscard]] float kdtree_get_pt(std::size_t i, std::size_t axis) const {
        return points[i][static_cast<Eigen::Index>(axis)];
    }
    template <class Box>
    bool kdtree_get_bbox(Box& /*box*/) const {
        return false;
    }
};
using NanoflannTree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, NanoflannCloud>,
                                                          NanoflannCloud, 3>;
constexpr std::size_t NanoflannLeaf = 10;  // its default; larger ones are slower here

const PointCloud& model() {
    return hall()[0].cloud;
}

const std::vector<Eigen::Vector3f>& queries() {
    static const auto points = moved(hall()[1].guessInFirst, hall()[1].cloud.points);
    return points;
}

pcl::PointCloud<pcl::PointXYZ>::Ptr pclModel() {
    auto cloud = std::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
    for (const Eigen::Vector3f& point : model().points) cloud->push_back({point.x(), point.y(), point.z()});
    return cloud;
}

/// Sum of the true distances from the model [m]: what every exact library must arrive at.
double trueSum() {
    static const double sum = [] {
        const auto search = makeSearch(model(), SearchMethod::KdTree);
        double result = 0.0;
        for (const auto& query : queries()) {
            const Neighbour found = search->nearest(query, Label::Unlabelled, 1e9F);
            result += std::sqrt(static_cast<double>(found.squaredDistance));
        }
        return result;
    }();
    return sum;
}

/// Times @p distanceOf, the squared distance [m^2] of the i-th query, over all queries, and checks their sum:
/// at least the true one and at most @p factor times it.
void timeQueries(benchmark::State& state, double factor, auto distanceOf) {
    const std::size_t count = queries().size();
    std::vector<float> distances(count);
    for (auto _ : state) {
        for (std::size_t i = 0; i < count; ++i) distances[i] = distanceOf(i);
        benchmark::DoNotOptimize(distances.data());
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(static_cast<std::int64_t>(count) * state.iterations());
    double sum = 0.0;
    for (const float distance : distances) sum += std::sqrt(static_cast<double>(distance));
    constexpr double Rounding = 1e-5;
    if (sum < trueSum() * (1.0 - Rounding) || sum > trueSum() * factor * (1.0 + Rounding)) {
        state.SkipWithError("the distances are wrong");
    }
}

void nearestLeitstand(benchmark::State& state) {
    const auto search = makeSearch(model(), SearchMethod::KdTree);
    timeQueries(state, 1.0, [&](std::size_t i) {
        return search->nearest(queries()[i], Label::Unlabelled, std::numeric_limits<float>::infinity())
            .squaredDistance;
    });
}

/// As ICP repeats it: the partner that the query had before it moved a little (1 cm, 0.1 degrees) is the
/// bound.
void nearestBounded(benchmark::State& state) {
    const auto search = makeSearch(model(), SearchMethod::KdTree);
    const Pose step = poseFrom({0.01, 0.0, 0.0}, 0.0, 0.0, degrees(0.1));
    std::vector<std::int32_t> partners;
    for (const auto& query : moved(step, queries())) {
        partners.push_back(search->nearest(query, Label::Unlabelled, 1e9F).index);
    }
    timeQueries(state, 1.0, [&](std::size_t i) {
        const Eigen::Vector3f& query = queries()[i];
        const float before = (model().points[static_cast<std::size_t>(partners[i])] - query).squaredNorm();
        return std::min(before, search->nearest(query, Label::Unlabelled, before).squaredDistance);
    });
}

void nearestApproximate(benchmark::State& state) {
    constexpr double Epsilon = 0.5;
    const auto search = makeSearch(model(), SearchMethod::Approximate, Epsilon);
    timeQueries(state, 1.0 + Epsilon, [&](std::size_t i) {
        return search->nearest(queries()[i], Label::Unlabelled, std::numeric_limits<float>::infinity())
            .squaredDistance;
    });
}

void nearestPcl(benchmark::State& state) {
    pcl::KdTreeFLANN<pcl::PointXYZ> tree;
    tree.setInputCloud(pclModel());
    std::vector<int> index(1);
    std::vector<float> distance(1);
    timeQueries(state, 1.0, [&](std::size_t i) {
        const Eigen::Vector3f& query = queries()[i];
        tree.nearestKSearch(pcl::PointXYZ(query.x(), query.y(), query.z()), 1, index, distance);
        return distance[0];
    });
}

void nearestNanoflann(benchmark::State& state) {
    const NanoflannCloud cloud{model().points};
    NanoflannTree tree(3, cloud, {NanoflannLeaf});
    timeQueries(state, 1.0, [&](std::size_t i) {
        std::uint32_t index = 0;
        float distance = 0.0F;
        tree.knnSearch(queries()[i].data(), 1, &index, &distance);
        return distance;
    });
}

void countModel(benchmark::State& state) {
    state.SetItemsProcessed(static_cast<std::int64_t>(model().size()) * state.iterations());
}

void buildLeitstand(benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(makeSearch(model(), SearchMethod::KdTree));
    countModel(state);
}

void buildPcl(benchmark::State& state) {
    const auto cloud = pclModel();
    for (auto _ : state) {
        pcl::KdTreeFLANN<pcl::PointXYZ> tree;
        tree.setInputCloud(cloud);
        benchmark::DoNotOptimize(&tree);
    }
    countModel(state);
}

void buildNanoflann(benchmark::State& state) {
    const NanoflannCloud cloud{model().points};
    for (auto _ : state) {
        const NanoflannTree tree(3, cloud, {NanoflannLeaf});
        benchmark::DoNotOptimize(&tree);
    }
    countModel(state);
}

BENCHMARK(nearestLeitstand)->Name("nearest/leitstand")->Unit(benchmark::kMillisecond);
BENCHMARK(nearestPcl)->Name("nearest/pcl")->Unit(benchmark::kMillisecond);
BENCHMARK(nearestNanoflann)->Name("nearest/nanoflann")->Unit(benchmark::kMillisecond);
BENCHMARK(nearestBounded)->Name("nearest_bounded/leitstand")->Unit(benchmark::kMillisecond);
BENCHMARK(nearestApproximate)->Name("nearest_approximate/leitstand")->Unit(benchmark::kMillisecond);
BENCHMARK(buildLeitstand)->Name("build/leitstand")->Unit(benchmark::kMillisecond);
BENCHMARK(buildPcl)->Name("build/pcl")->Unit(benchmark::kMillisecond);
BENCHMARK(buildNanoflann)->Name("build/nanoflann")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace leitstand::benchmarks
