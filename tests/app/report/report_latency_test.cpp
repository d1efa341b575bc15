#include <sys/resource.h>

#include <chrono>
#include <cstdio>
#include <filesystem>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/mission/state/scan_state.h"
#include "tests/app/report/driven_mission.h"
#include "tests/support/latency.h"
#include "tests/support/places.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double AskedSeconds = 20.0, MostSeconds = Generous * AskedSeconds;

double secondsSince(Clock::time_point began) {
    return std::chrono::duration<double>(Clock::now() - began).count();
}

/// Processor time of the processes that have ended [s].
double processorSeconds() {
    rusage used{};
    EXPECT_EQ(::getrusage(RUSAGE_CHILDREN, &used), 0);
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    return seconds(used.ru_utime) + seconds(used.ru_stime);
}

TEST(ReportLatency, OfAMissionOfTwentyMinutesIsThereInTwentySeconds) {
    const TemporaryFolder folder;
    const auto mission = folder / "final", out = folder / "out";
    const auto began = Clock::now();
    const DrivenMission made = writeDrivenMission(mission);
    ASSERT_FALSE(HasFailure());
    ASSERT_GE(made.keyScans, 390u);
    ASSERT_GE(made.points, 9'000u * made.keyScans);
    ASSERT_EQ(made.victims, 6u);
    std::printf("20 minutes with %zu events, %zu key scans of %zu points in all, written in %.1f s\n",
                made.events, made.keyScans, made.points, secondsSince(began));
    std::fflush(stdout);

    const auto asked = Clock::now();
    const double before = processorSeconds();
    const ProcessOutcome report =
        runProcess(program("leitstandctl"), {"report", mission.string(), "--out", out.string(), "--json"});
    const double took = secondsSince(asked), computed = processorSeconds() - before;
    ASSERT_EQ(report.exitCode, 0) << report.err;
    std::printf("its report took %.1f s, %.1f s of a processor (asked %.0f)\n", took, computed, AskedSeconds);
    const auto json = nlohmann::json::parse(report.out);
    EXPECT_EQ(json["scans"], made.keyScans) << "all of it is in the report";
    EXPECT_EQ(json["victims"], made.victims);
    for (const auto& one : json["files"]) EXPECT_TRUE(one["whole"].get<bool>()) << one;
    for (const char* ending : {".tif", ".pdf", ".bt", ".ply", "_kurt3d.tum", "_crawler.tum"})
        EXPECT_TRUE(std::filesystem::exists(out / ("RoboCup2013-Deutschland1-Final_2" + std::string(ending))))
            << ending;
    EXPECT_LE(computed, AskedSeconds) << "whatever else the machine does";
    EXPECT_LE(took, MostSeconds);
}

}  // namespace
}  // namespace leitstand::test
