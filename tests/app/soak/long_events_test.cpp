// Eight hours of the demo's events in one, all of which have to be in the log.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <set>
#include <string>
#include <thread>

#include <gtest/gtest.h>

#include "core/mission/state/scan_state.h"
#include "core/robot/robot_description.h"
#include "tests/app/robots/robot_process.h"
#include "tests/app/soak/played_demo.h"
#include "tests/app/soak/soak_limits.h"
#include "tests/app/soak/station_process.h"
#include "tests/support/dds/test_domain.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/wait.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;

constexpr double EventsRate = 8.0;    ///< of the mission's time to real time
constexpr double FirstMinutes = 2.0;  ///< until all threads are there, and all buffers

/// How a station does after so much was said.
struct Reading {
    double megabytes = 0.0;
    int threads = 0, descriptors = 0;
    Logged log;
};

/// Waits until @p station rests. Counted are threads and descriptors that stay: some come for a moment's
/// work.
Reading readingOf(const StationProcess& station) {
    EXPECT_TRUE(worksOff(station));
    Reading reading{0.0, station.threads(), station.descriptors(), {}};
    for (auto passed = 0s; passed < GivenBack; passed += 1s) {
        std::this_thread::sleep_for(1s);
        reading.threads = std::min(reading.threads, station.threads());
        reading.descriptors = std::min(reading.descriptors, station.descriptors());
    }
    reading.megabytes = station.residentMegabytes();
    reading.log = loggedIn(station.mission());
    return reading;
}

void print(const char* when, const Reading& reading) {
    std::printf(
        "%s: %.0f MB, %llu key scans, %d threads, %d descriptors, %llu events came, %llu are logged\n", when,
        reading.megabytes, static_cast<unsigned long long>(reading.log.keyScans), reading.threads,
        reading.descriptors, static_cast<unsigned long long>(reading.log.lastSequence),
        static_cast<unsigned long long>(reading.log.events));
    std::fflush(stdout);
}

/// Topics that both robots send reliably, but pictures: none of their samples may be lost on the way either.
std::set<std::string> reliableTopics() {
    std::set<std::string> topics;
    for (const char* robot : {"kurt3d", "crawler"}) {
        for (const StreamDescription& stream : shippedRobot(robot).streams) {
            if (stream.qos.reliability == Qos::Reliability::Reliable) topics.insert(stream.topic);
        }
    }
    return topics;
}

TEST(LongSoak, OfEightHoursOfEventsNoneIsLostAndNothingGrowsButTheMap) {
    const TemporaryFolder folder;
    const TestDomain domain;
    std::filesystem::path demo;
    ASSERT_NO_THROW(demo = recordedDemo(folder.path()));
    const double length = secondsOf(demo);
    const StationProcess station(folder.path(), domain.number());
    ASSERT_TRUE(waitUntil([&] { return station.out().find("recorded into") != std::string::npos; }, 60s));

    const auto replay = replayOf(demo, domain.number(), EventsRate, false);
    const std::atomic<bool> never = false;
    const auto roundsIn = [&](double some) {
        return std::max(1, static_cast<int>(some * 60.0 * EventsRate / length + 0.5));
    };
    int rounds = 0;
    ReplayOutcome outcome;
    const auto playUntil = [&](int end) {
        for (; rounds < end; ++rounds) outcome = replay->play(never, {});
    };
    playUntil(roundsIn(FirstMinutes));
    const Reading first = readingOf(station);
    print("after the first minutes", first);
    const int all = roundsIn(soakTime().count() / 60.0);
    Reading middle;
    for (int quarter = 1; quarter <= 4; ++quarter) {
        playUntil(std::max(rounds, quarter * all / 4));
        std::printf("%4.1f h of events: %.0f MB in the rush\n", rounds * length / 3600.0,
                    station.residentMegabytes());
        std::fflush(stdout);
        if (quarter != 2) continue;
        middle = readingOf(station);
        print("half-way", middle);
    }
    const Reading last = readingOf(station);
    print("at the end", last);
    EXPECT_TRUE(outcome.problems.empty()) << outcome.problems.front();

    EXPECT_EQ(last.log.events, last.log.lastSequence) << "events came that are not in the log";
    const auto reported = messagesIn(demo), received = messagesIn(station.mission());
    const std::set<std::string> reliable = reliableTopics();
    for (const auto& [topic, count] : reported) {
        const auto found = received.find(topic);
        const std::uint64_t got = found == received.end() ? 0 : found->second;
        const std::uint64_t sent = count * static_cast<std::uint64_t>(rounds);
        if (sent == 0) continue;  // announced only
        std::printf("%8.4f %% of %llu on %s%s\n",
                    100.0 * static_cast<double>(got) / static_cast<double>(sent),
                    static_cast<unsigned long long>(sent), topic.c_str(),
                    reliable.contains(topic) ? ", reliable" : "");
        if (reliable.contains(topic)) {
            EXPECT_EQ(got, sent) << topic;
        } else if (count >= 10) {
            EXPECT_GE(static_cast<double>(got), LeastHeard * static_cast<double>(sent)) << topic;
        }
    }
    // A library may start one of its threads late; none comes for ever.
    EXPECT_LE(middle.threads, first.threads + 1);
    EXPECT_EQ(last.threads, middle.threads);
    EXPECT_EQ(last.descriptors, first.descriptors);
    const auto scans = static_cast<double>(last.log.keyScans - first.log.keyScans);
    std::printf("%.0f key scans more, %.2f MB each\n", scans, (last.megabytes - first.megabytes) / scans);
    EXPECT_GT(scans, 0.0);
    EXPECT_LE(last.megabytes, first.megabytes + MostMegabytesAScan * scans);
}

}  // namespace
}  // namespace leitstand::test
