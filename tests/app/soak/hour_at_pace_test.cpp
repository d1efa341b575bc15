// An hour of both robots at their own pace, and a station with its window: all that they send is in the log.
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "core/event/stream_role.h"
#include "core/mission/state/scan_state.h"
#include "tests/app/robots/robot_process.h"
#include "tests/app/soak/exploring_desk.h"
#include "tests/app/soak/played_demo.h"
#include "tests/app/soak/soak_limits.h"
#include "tests/app/soak/station_process.h"
#include "tests/app/soak/witness.h"
#include "tests/support/dds/test_domain.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/wait.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

constexpr int Parts = 12;             ///< of the time: five minutes of an hour
constexpr double MostLost = 0.01;     ///< of what robots send once and never again
constexpr std::uint64_t Steady = 50;  ///< samples, of which a share is told

/// A station at a moment of the hour. Counted are threads and descriptors that stay, and memory that was not
/// about to be given back: the least in the seconds before.
struct Moment {
    double megabytes = 1e9;
    int threads = 1'000, descriptors = 10'000;
    std::uint64_t keyScans = 0;
};

/// Both shipped robots, a station with its window, and an operator who lets the robots explore.
class HourAtPace {
public:
    explicit HourAtPace(std::chrono::duration<double> length) : m_part(length / Parts) {
        for (const char* name : {"kurt3d", "crawler"}) m_robots.push_back(shippedRobot(name));
        // The Crawler's laser does not turn here.
        std::erase_if(m_robots[1].streams,
                      [](const StreamDescription& stream) { return stream.role == StreamRole::Points; });
        m_witness.emplace(m_domain, m_robots);
    }

    /// Starts all; false when one of them does not come.
    [[nodiscard]] bool begins() {
        m_station.emplace(m_folder.path(), m_domain.number());
        if (!waitUntil([&] { return m_station->out().find("recorded into") != std::string::npos; }, 60s))
            return false;
        const std::vector<std::string> demo = {"--arena", "yellow", "--seed", "7", "--interface", "lo"};
        m_kurt3d.emplace(m_domain, "kurt3d", demo);
        m_crawler.emplace(m_domain, "crawler", demo);
        m_desk.emplace(m_domain, std::vector<std::string>{"kurt3d", "crawler"});
        return waitUntil([&] { return m_desk->look(), m_desk->allExplore(); }, 60s) && m_witness->listen();
    }

    /// Lets a part of the time pass.
    Moment passes(int part) {
        const double before = m_station->processorSeconds();
        const auto began = Clock::now(), end = began + std::chrono::duration_cast<Clock::duration>(m_part);
        const auto rests = end - std::min<Clock::duration>(GivenBack, (end - began) / 2);
        Moment moment;
        while (Clock::now() < end) {
            std::this_thread::sleep_for(500ms);
            m_desk->look();
            const double megabytes = m_station->residentMegabytes();
            m_most = std::max(m_most, megabytes);
            if (Clock::now() < rests) continue;
            moment.megabytes = std::min(moment.megabytes, megabytes);
            moment.threads = std::min(moment.threads, m_station->threads());
            moment.descriptors = std::min(moment.descriptors, m_station->descriptors());
        }
        moment.keyScans = loggedIn(m_station->mission()).keyScans;
        const double cores = (m_station->processorSeconds() - before) / Seconds(Clock::now() - began).count();
        std::printf("%6.1f  %5.0f  %5.0f  %9llu  %5.2f  %7d  %11d  %s\n", (m_part * part).count() / 60.0,
                    moment.megabytes, m_most, static_cast<unsigned long long>(moment.keyScans), cores,
                    moment.threads, moment.descriptors, m_desk->doing().c_str());
        std::fflush(stdout);
        return moment;
    }

    /// Ends all; expects that everyone ends well.
    void ends() {
        EXPECT_TRUE(m_witness->listen());
        std::this_thread::sleep_for(2s);  // what is repeated on the way comes by then
        m_station->terminate();
        EXPECT_EQ(m_station->waitForEnd(), 0) << m_station->out();
        m_desk.reset();
        EXPECT_EQ(m_kurt3d->end(SIGTERM), 0) << m_kurt3d->out();
        EXPECT_EQ(m_crawler->end(SIGTERM), 0) << m_crawler->out();
    }

    void expectAllIsLogged() const {
        const Logged log = loggedIn(m_station->mission());
        EXPECT_EQ(log.events, log.lastSequence) << "events came that are not in the log";
        for (const Kept& kept : m_witness->compare(m_station->mission())) {
            if (kept.sent == 0) continue;
            const auto sent = static_cast<double>(kept.sent), logged = static_cast<double>(kept.logged);
            std::printf("%9.4f %% of %llu on %s (%s)%s\n", 100.0 * logged / sent,
                        static_cast<unsigned long long>(kept.sent), kept.topic.c_str(), kept.robot.c_str(),
                        kept.reliable ? ", reliable" : "");
            if (kept.reliable) {
                EXPECT_EQ(kept.logged, kept.sent) << kept.topic;
            } else if (kept.sent >= Steady) {
                EXPECT_GE(logged, (1.0 - MostLost) * sent) << kept.topic;
            }
        }
    }
    [[nodiscard]] double most() const { return m_most; }  ///< memory at any time [MB]
    [[nodiscard]] std::string reported() const { return m_station->out() + m_desk->doing(); }

private:
    const TemporaryFolder m_folder;
    const TestDomain m_domain;
    const Seconds m_part;
    std::vector<RobotDescription> m_robots;
    double m_most = 0.0;
    std::optional<Witness> m_witness;
    std::optional<StationProcess> m_station;
    std::optional<RobotProcess> m_kurt3d, m_crawler;
    std::optional<ExploringDesk> m_desk;
};

TEST(LongSoak, AnHourAtPaceLosesNothingAndFitsIntoOnePointTwoGigabytes) {
    HourAtPace hour(soakTime());
    ASSERT_TRUE(hour.begins()) << hour.reported();
    std::printf("minute     MB   most  key scans  cores  threads  descriptors\n");
    std::vector<Moment> moments;
    for (int part = 1; part <= Parts; ++part) moments.push_back(hour.passes(part));
    hour.ends();
    hour.expectAllIsLogged();

    const Moment &first = moments.front(), &middle = moments[Parts / 2 - 1], &last = moments.back();
    // A library may start one of its threads late; none comes for ever.
    EXPECT_LE(middle.threads, first.threads + 1);
    EXPECT_EQ(last.threads, middle.threads);
    EXPECT_EQ(last.descriptors, first.descriptors);
    expectFits({.first = first.megabytes,
                .last = last.megabytes,
                .most = hour.most(),
                .keyScansFirst = first.keyScans,
                .keyScansLast = last.keyScans});
}

}  // namespace
}  // namespace leitstand::test
