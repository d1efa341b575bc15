#include <cstdint>
#include <memory>

#include <benchmark/benchmark.h>
#include <pcl/filters/voxel_grid.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include "core/cloud/filters/voxel_grid.h"
#include "tests/support/rooms.h"

// A million points spread over a furnished room in random order, cubes of 10 cm. An item is a point.
namespace leitstand::benchmarks {
namespace {

constexpr double Edge = 0.10;  // [m]

const PointCloud& room() {
    static const PointCloud cloud = [] {
        PointCloud points = test::roomCloud(1'000'000, /*seed=*/1);
        points.normals.clear();
        points.labels.clear();
        return points;
    }();
    return cloud;
}

void finish(benchmark::State& state, std::size_t cubes) {
    state.SetItemsProcessed(static_cast<std::int64_t>(room().size()) * state.iterations());
    state.counters["cubes"] = static_cast<double>(cubes);
}

void voxelsOfLeitstand(benchmark::State& state, VoxelPoint kept) {
    std::size_t cubes = 0;
    for (auto _ : state) {
        const PointCloud reduced = voxelGrid(room(), Edge, kept);
        cubes = reduced.size();
        benchmark::DoNotOptimize(reduced.points.data());
    }
    finish(state, cubes);
}

void voxelsOfPcl(benchmark::State& state) {
    const auto cloud = std::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
    for (const Eigen::Vector3f& point : room().points) cloud->push_back({point.x(), point.y(), point.z()});
    pcl::PointCloud<pcl::PointXYZ> reduced;
    for (auto _ : state) {
        pcl::VoxelGrid<pcl::PointXYZ> grid;
        grid.setInputCloud(cloud);
        grid.setLeafSize(static_cast<float>(Edge), static_cast<float>(Edge), static_cast<float>(Edge));
        grid.filter(reduced);
        benchmark::DoNotOptimize(reduced.points.data());
    }
    finish(state, reduced.size());
}

BENCHMARK_CAPTURE(voxelsOfLeitstand, nearest, VoxelPoint::Nearest)
    ->Name("voxel_grid/leitstand")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(voxelsOfLeitstand, centroid, VoxelPoint::Centroid)
    ->Name("voxel_grid_centroid/leitstand")
    ->Unit(benchmark::kMillisecond);
BENCHMARK(voxelsOfPcl)->Name("voxel_grid/pcl")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace leitstand::benchmarks
