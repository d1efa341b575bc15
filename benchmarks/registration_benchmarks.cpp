#include <benchmark/benchmark.h>

#include "benchmarks/hall.h"
#include "benchmarks/pcl_registration.h"
#include "core/mapping/scan_preparation.h"
#include "core/registration/icp.h"

// scan001 onto scan000 from the odometry, one thread unless the name says otherwise. Every result is checked
// to be where the hall's scans belong, so that no library is fast by being wrong.

namespace leitstand::benchmarks {
namespace {

constexpr double IcpDistance = 0.25, VoxelDistance = 0.5;  // [m]
constexpr double VoxelEdge = 0.10;                         // [m]
constexpr int IcpIterations = 20;

/// Both libraries end within this of each other on all points and on voxels [m].
constexpr double Plausible = 0.10;

void check(benchmark::State& state, const Pose& pose) {
    const Eigen::Vector3d expected(1.562, 0.041, -0.076);  // ../shared/data/README.md
    if ((pose.translation() - expected).norm() > Plausible)
        state.SkipWithError("the scans were not registered");
}

PclRegistration& pcl() {
    static PclRegistration registration(hall()[0].cloud.points, hall()[1].cloud.points);
    return registration;
}

void icpIteration(benchmark::State& state, int threads) {
    const PointCloud &target = hall()[0].cloud, &source = hall()[1].cloud;
    const auto search = makeSearch(target, SearchMethod::KdTree);
    IcpSettings settings;
    settings.maxDistances = {IcpDistance};
    settings.minimizer = Minimizer::Svd;
    settings.minStep = 0.0;
    settings.maxIterations = IcpIterations;
    settings.threads = threads;
    while (state.KeepRunningBatch(IcpIterations)) {
        const IcpResult result = align(target, *search, source, hall()[1].guessInFirst, settings);
        if (result.iterations != IcpIterations) state.SkipWithError("ended before its iterations were run");
        check(state, result.pose);
    }
}

void icpIterationPcl(benchmark::State& state) {
    while (state.KeepRunningBatch(IcpIterations)) {
        if (pcl().icp(hall()[1].guessInFirst, IcpDistance, IcpIterations) != IcpIterations) {
            state.SkipWithError("ended before its iterations were run");
        }
    }
}

void gicp(benchmark::State& state, double reduce, double maxDistance, int threads) {
    RegistrationSettings preparation;
    preparation.reduce = reduce;
    preparation.minRange = 0.48;
    preparation.maxRange = 25.0;
    preparation.threads = threads;
    IcpSettings settings;
    settings.maxDistances = {maxDistance};
    settings.threads = threads;
    for ([[maybe_unused]] auto _ : state) {
        const PointCloud target = prepared(hall()[0].scan, preparation),
                         source = prepared(hall()[1].scan, preparation);
        const auto search = makeSearch(target, SearchMethod::KdTree);
        check(state, align(target, *search, source, hall()[1].guessInFirst, settings).pose);
    }
}

void gicpPcl(benchmark::State& state) {
    for ([[maybe_unused]] auto _ : state) check(state, pcl().gicp(hall()[1].guessInFirst, IcpDistance));
}

void gicpVoxelPcl(benchmark::State& state) {
    for ([[maybe_unused]] auto _ : state) {
        check(state,
              pcl().gicpOfVoxels(hall()[1].guessInFirst, VoxelDistance, static_cast<float>(VoxelEdge)));
    }
}

BENCHMARK_CAPTURE(icpIteration, one, 1)->Name("icp_iteration/leitstand")->Unit(benchmark::kMillisecond);
BENCHMARK(icpIterationPcl)->Name("icp_iteration/pcl")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(icpIteration, two, 2)->Name("icp_2threads/leitstand")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(gicp, all, 0.0, IcpDistance, 1)->Name("gicp/leitstand")->Unit(benchmark::kMillisecond);
BENCHMARK(gicpPcl)->Name("gicp/pcl")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(gicp, two, 0.0, IcpDistance, 2)
    ->Name("gicp_2threads/leitstand")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(gicp, voxel, VoxelEdge, VoxelDistance, 1)
    ->Name("gicp_voxel/leitstand")
    ->Unit(benchmark::kMillisecond);
BENCHMARK(gicpVoxelPcl)->Name("gicp_voxel/pcl")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace leitstand::benchmarks
