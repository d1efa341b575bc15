// An hour of the demo, from a mission that is said again and again at several times its pace.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>

#include <gtest/gtest.h>

#include "app/session/log/mission_replay.h"
#include "app/session/log/replay_rules.h"
#include "app/session/log/sequencer.h"
#include "core/io/bag/bag_reader.h"
#include "core/mission/station_topics.h"
#include "tests/app/soak/demo_recording.h"
#include "tests/app/soak/station_process.h"
#include "tests/support/dds/test_domain.h"
#include "tests/support/places.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/wait.h"
#include "tests/transport/dds/test_node.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds Recorded(120);  ///< and the way back
constexpr double Hour = 3600.0;                ///< [s]
constexpr double Rate = 12.0;                  ///< of the mission's time to real time
constexpr double MostMegabytes = 1500.0, MostCores = 1.0;
constexpr double MostMegabytesAScan = 0.9;  ///< that enters the map
constexpr double LeastHeard = 0.95;  ///< of what was said, pictures apart: 12 times as much as robots say
constexpr double Warming = 5.0, AtRateOne = 40.0;  ///< [s]
constexpr double MostSecondsOfReport = 20.0;       ///< of a mission of 20 minutes
constexpr double Calm = 0.5;                       ///< cores of a station that has worked off all that came
constexpr std::chrono::seconds Behind(2);          ///< at most, is its log then
constexpr std::chrono::minutes WorkOff(2);         ///< at most
constexpr int GivesBack = 20;  ///< minutes after which it is waited for, that it gives free memory back
constexpr std::chrono::seconds GivenBack(22);  ///< a station does so every 20 s, whatever robots' pace

/// A mission that is played in a thread of its own as long as this lives.
class Playing {
public:
    Playing(const std::filesystem::path& mission, int domain, double rate) {
        ReplaySettings settings;
        settings.mission = mission;
        settings.domain.domain = domain;
        settings.domain.interfaces = {"lo"};
        settings.rate = rate;
        settings.loop = true;
        m_replay = must(MissionReplay::open(settings));
        m_thread = std::jthread([this](const std::stop_token& stop) {
            const Progress progress{[this](double fraction) { note(fraction); }, stop};
            m_outcome = m_replay->play(m_paused, progress);
        });
    }
    /// How much of the mission was said, in rounds.
    [[nodiscard]] double rounds() const { return m_rounds; }
    void pause(bool on) { m_paused = on; }
    ReplayOutcome end() {
        m_thread.request_stop();
        m_thread.join();
        return m_outcome;
    }

private:
    void note(double fraction) {
        if (fraction < m_fraction) ++m_whole;
        m_fraction = fraction;
        m_rounds = m_whole + fraction;
    }

    std::unique_ptr<MissionReplay> m_replay;
    std::atomic<bool> m_paused = false;
    double m_fraction = 0.0, m_whole = 0.0;
    std::atomic<double> m_rounds = 0.0;
    ReplayOutcome m_outcome;
    std::jthread m_thread;
};

/// Messages in @p mission on topics that a replay says, but pictures; by topic.
std::map<std::string, std::uint64_t> messagesIn(const std::filesystem::path& mission) {
    const auto bag = must(BagReader::open(mission));
    bag->count();
    std::map<std::string, std::uint64_t> counts;
    for (const BagTopic& topic : bag->topics()) {
        if (!isReplayable(topic.info.name, topic.info.type) || topic.info.type.ends_with("Image")) continue;
        counts[topic.info.name] += topic.messages.value_or(0);
    }
    return counts;
}

/// What the log of a station has at a moment.
struct Logged {
    Time last{};  ///< station's clock
    std::uint64_t keyScans = 0;
};

Logged loggedIn(const std::filesystem::path& mission) {
    const auto bag = must(BagReader::open(mission));
    bag->count();
    Logged logged{bag->last(), 0};
    for (const BagTopic& topic : bag->topics()) {
        if (topic.info.name == station_topic::KeyScans) logged.keyScans = topic.messages.value_or(0);
    }
    return logged;
}

/// Waits until @p station has worked off what came many times as fast as robots say it: what waits for the
/// disk or for a thread is no memory that an hour of robots costs. False where it did not within WorkOff.
bool worksOff(const StationProcess& station) {
    auto since = Clock::now();
    double used = station.processorSeconds();
    return waitUntil(
        [&] {
            const double passed = std::chrono::duration<double>(Clock::now() - since).count();
            if (passed < 1.0) return false;
            const double cores = (station.processorSeconds() - used) / passed;
            since = Clock::now();
            used = station.processorSeconds();
            if (cores > Calm) return false;
            return stationTime() - loggedIn(station.mission()).last < Behind;
        },
        WorkOff);
}

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

/// Records the demo into a folder in @p folder, which it returns. What the robots meet on their way is theirs
/// to know: where one gets stuck, another one is recorded.
std::filesystem::path recordedDemo(const std::filesystem::path& folder) {
    constexpr int Attempts = 3;
    for (int attempt = 1;; ++attempt) {
        const auto demo = folder / ("demo_" + std::to_string(attempt));
        try {
            recordDemo(demo, Recorded);
            return demo;
        } catch (const std::runtime_error& problem) {
            std::printf("recording %d of %d: %s\n", attempt, Attempts, problem.what());
            std::fflush(stdout);
            if (attempt == Attempts) throw;
        }
    }
}

TEST(LongSoak, AnHourOfTheDemoFitsIntoOneCoreAndOneAndAHalfGigabytes) {
    const TemporaryFolder folder;
    const TestDomain domain;
    std::filesystem::path demo;
    ASSERT_NO_THROW(demo = recordedDemo(folder.path()));
    const double length = [&] {
        const auto bag = must(BagReader::open(demo));
        return std::chrono::duration<double>(bag->last() - bag->first()).count();
    }();
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
    EXPECT_LE(most, MostMegabytes);
    EXPECT_LE(coresFirst, MostCores);
    EXPECT_LE(coresLast, MostCores) << "an hour makes the station slower";
    EXPECT_LE(usedForIt, MostCores * Hour);

    ASSERT_GT(scans, scansAtFive);
    const double aScan = (most - atFive) / static_cast<double>(scans - scansAtFive);
    std::printf("%llu key scans, %.2f MB each\n", static_cast<unsigned long long>(scans), aScan);
    EXPECT_LE(aScan, MostMegabytesAScan);
    const double whole = Hour + 2.0 * (AtRateOne + Warming - 2.0);  // a replay listens first for 2 s
    const auto said = messagesIn(demo), heard = messagesIn(station.mission());
    for (const auto& [topic, count] : said) {
        if (count < 10) continue;  // states that stay
        const double expected = static_cast<double>(count) * whole / length;
        const auto found = heard.find(topic);
        const double got = found == heard.end() ? 0.0 : static_cast<double>(found->second);
        std::printf("%6.2f %% of %s\n", 100.0 * got / expected, topic.c_str());
        EXPECT_GE(got, LeastHeard * expected) << topic;
    }
}

}  // namespace
}  // namespace leitstand::test
