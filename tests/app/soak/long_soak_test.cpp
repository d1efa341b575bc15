// An hour of the demo, from a mission that is said again and again at several times its pace.
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <string>
#include <thread>

#include <gtest/gtest.h>

#include "core/mission/state/scan_state.h"
#include "tests/app/soak/played_demo.h"
#include "tests/app/soak/soak_limits.h"
#include "tests/app/soak/station_process.h"
#include "tests/support/dds/test_domain.h"
#include "tests/support/places.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/wait.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr double Hour = 3600.0;  ///< [s]
constexpr double Rate = 12.0;    ///< of the mission's time to real time
constexpr double MostCores = 1.0;
constexpr double Warming = 5.0, AtRateOne = 40.0;  ///< [s]
constexpr double MostSecondsOfReport = 20.0;       ///< of a mission of 20 minutes
constexpr int GivesBack = 20;  ///< minutes after which it is waited for, that it gives free memory back

/// Cores that @p station uses while a mission is said as fast as it was.
double coresAtRateOne(const StationProcess& station, const std::filesystem::path& mission, int domain) {
    Playing playing(mission, domain, 1.0);
    const auto passed = [began = Clock::now()] {
        return std::chrono::duration<double>(Clock::now() - began).count();
    };
    (void)waitUntil([&] { return passed() > Warming; }, 10s);  // what comes first is dearer
    const double before = passed(), used = station.processorSeconds();
    (void)waitUntil([&] { return passed() > before + AtRateOne; }, 60s);
    return (station.processorSeconds() - used) / (passed() - before);
}

/// Seconds that the report of @p mission takes, which is still recorded; infinite where there is none.
double reportOf(const std::filesystem::path& mission, const std::filesystem::path& out) {
    const auto began = Clock::now();
    const ProcessOutcome report =
        runProcess(program("leitstandctl"), {"report", mission.string(), "--out", out.string()});
    EXPECT_EQ(report.exitCode, 0) << report.err;
    if (report.exitCode != 0) return std::numeric_limits<double>::infinity();
    return std::chrono::duration<double>(Clock::now() - began).count();
}

TEST(LongSoak, AnHourOfTheDemoFitsIntoOneCoreAndOnePointTwoGigabytes) {
    const TemporaryFolder folder;
    const TestDomain domain;
    std::filesystem::path demo;
    ASSERT_NO_THROW(demo = recordedDemo(folder.path()));
    const double length = secondsOf(demo);
    const StationProcess station(folder.path(), domain.number());
    ASSERT_TRUE(waitUntil([&] { return station.out().find("recorded into") != std::string::npos; }, 60s));
    const double coresFirst = coresAtRateOne(station, demo, domain.number());

    std::printf(
        "%.0f s of the demo, said %.0f times as fast\n"
        "minute     MB  key scans  cores  cores of the demo's time  memory while it came\n"
        "%6d  %5.0f\n",
        length, Rate, 0, station.residentMegabytes());
    double most = 0.0, atFive = 0.0;
    std::uint64_t scansAtFive = 0, scans = 0;
    double used = station.processorSeconds();
    const double usedAtFirst = used;
    {
        Playing playing(demo, domain.number(), Rate);
        auto at = Clock::now();
        for (int minute = 5; minute <= 60; minute += 5) {
            const double until = minute * 60.0;
            ASSERT_TRUE(waitUntil([&] { return playing.rounds() * length >= until; }, 10min)) << minute;
            playing.pause(true);
            const double inRush = station.residentMegabytes();
            const bool workedOff = worksOff(station), atRest = minute == 5 || minute % GivesBack == 0;
            const double seconds = station.processorSeconds() - used;
            const double wall = std::chrono::duration<double>(Clock::now() - at).count();
            if (atRest) std::this_thread::sleep_for(GivenBack);
            const double megabytes = station.residentMegabytes();
            scans = loggedIn(station.mission()).keyScans;
            std::printf("%6d  %5.0f  %9llu  %5.2f  %24.2f  %13.0f%s\n", minute, megabytes,
                        static_cast<unsigned long long>(scans), seconds / wall, seconds / 300.0, inRush,
                        workedOff ? "" : ", not worked off");
            std::fflush(stdout);
            EXPECT_TRUE(workedOff) << "after minute " << minute;
            if (atRest) most = std::max(most, megabytes);
            if (minute == 5) {
                atFive = megabytes;
                scansAtFive = scans;
            }
            if (minute == 20) {
                const double took = reportOf(station.mission(), folder / "report");
                std::printf("        the report of 20 minutes took %.1f s\n", took);
                EXPECT_LE(took, MostSecondsOfReport);
            }
            used = station.processorSeconds();
            at = Clock::now();
            playing.pause(false);
        }
        const ReplayOutcome outcome = playing.end();
        EXPECT_TRUE(outcome.problems.empty()) << outcome.problems.front();
    }
    const double usedForIt = station.processorSeconds() - usedAtFirst;
    const double coresLast = coresAtRateOne(station, demo, domain.number());
    std::printf(
        "at the demo's own pace %.2f cores at first, %.2f after the hour; %.0f s for the hour's samples\n",
        coresFirst, coresLast, usedForIt);
    EXPECT_LE(coresFirst, MostCores);
    EXPECT_LE(coresLast, MostCores) << "an hour makes the station slower";
    EXPECT_LE(usedForIt, MostCores * Hour);

    expectFits(
        {.first = atFive, .last = most, .most = most, .keyScansFirst = scansAtFive, .keyScansLast = scans});
    const double whole = Hour + 2.0 * (AtRateOne + Warming - 2.0);  // a replay listens first for 2 s
    const auto reported = messagesIn(demo), received = messagesIn(station.mission());
    for (const auto& [topic, count] : reported) {
        if (count < 10) continue;  // states that stay
        const double expected = static_cast<double>(count) * whole / length;
        const auto found = received.find(topic);
        const double got = found == received.end() ? 0.0 : static_cast<double>(found->second);
        std::printf("%6.2f %% of %s\n", 100.0 * got / expected, topic.c_str());
        EXPECT_GE(got, LeastHeard * expected) << topic;
    }
}

}  // namespace
}  // namespace leitstand::test
