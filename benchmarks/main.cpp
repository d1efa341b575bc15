#include <cstdio>
#include <exception>

#include <benchmark/benchmark.h>

#include "benchmarks/hall.h"

// Names are <job>/<library> and nothing more (hence no UseRealTime()); take real_time from the JSON output.
int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    try {
        if (leitstand::benchmarks::hall().empty()) return 1;
        benchmark::RunSpecifiedBenchmarks();
    } catch (const std::exception& error) {
        std::fprintf(stderr, "leitstand_benchmarks: %s\n", error.what());
        return 1;
    }
    return 0;
}
