#include <chrono>
#include <cstdint>
#include <cstdio>
#include <deque>
#include <optional>
#include <thread>

#include <gtest/gtest.h>

#include "tests/support/net/radio_link.h"
#include "tests/transport/link/control_robot.h"
#include "tests/transport/link/control_station.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

/// A robot with our watchdog, driven over a link of 5 % loss whose packets come 20 to 40 ms late.
class DriveOverRadio : public testing::Test {
protected:
    void SetUp() override {
        if (const std::string why = whyNoNodesInNamespaces(); !why.empty())
            GTEST_SKIP() << "SKIPPED: the radio link needs network namespaces and TUN: " << why;
        m_radio.emplace(RadioConditions{.delay = 20ms, .jitter = 20ms, .loss = 0.05});
        {
            const InNamespace there(m_radio->robots());
            m_there = nodeIn(m_domain);
            m_robot = std::make_unique<ControlRobot>(*m_there, m_description);
        }
        const InNamespace here(m_radio->station());
        m_here = nodeIn(m_domain);
        m_station = std::make_unique<ControlStation>(*m_here, m_description);
        m_station->ask();
        ASSERT_TRUE(waitUntil([&] { return m_station->mayDrive(); }));
        ASSERT_TRUE(m_station->driveUntil(0.3, [&] { return m_robot->speed() > 0.0; }));
    }
    /// Whether commands were sent in time up to @p now: where the station's own process did not run, the link
    /// is not to blame.
    [[nodiscard]] static bool isPunctual(const std::deque<Clock::time_point>& sent, Clock::time_point now) {
        auto later = now;
        for (auto one = sent.rbegin(); one != sent.rend() && now - later < 300ms; ++one) {
            if (later - *one > 80ms) return false;
            later = *one;
        }
        return !sent.empty();
    }
    /// How often the robot stands while its stick is held for @p duration, looked at a thousand times a
    /// second.
    [[nodiscard]] int stutters(std::chrono::seconds duration) const {
        int count = 0, late = 0;
        bool moved = true;
        std::deque<Clock::time_point> sent, came;  // newest of what was seen to be sent and to come
        std::uint64_t lastSent = 0, lastCame = 0;
        const auto note = [](std::deque<Clock::time_point>& moments, std::uint64_t& last, std::uint64_t now,
                             Clock::time_point at) {
            if (last != now) moments.push_back(at);
            last = now;
            if (moments.size() > 8) moments.pop_front();
        };
        const auto reported = [](const char* what, const std::deque<Clock::time_point>& moments,
                                 Clock::time_point now) {
            std::printf("  %s", what);
            for (const auto one : moments)
                std::printf(" %.0f", std::chrono::duration<double, std::milli>(now - one).count());
            std::printf(" ms before\n");
        };
        auto next = Clock::now();
        for (const auto end = next + duration; next < end; next += 1ms) {
            std::this_thread::sleep_until(next);
            const auto now = Clock::now();
            note(sent, lastSent, m_station->streamer().status().sent, now);
            note(came, lastCame, m_robot->commands().counts().taken, now);
            const bool moves = m_robot->speed() > 0.0;
            if (moved && !moves) {
                ++(isPunctual(sent, now) ? count : late);
                const DriveStatus status = m_station->streamer().status();
                std::printf("stutter %d, %d late: the station says %.1f m/s, needs neutral %d\n", count, late,
                            status.velocity.forward, status.needsNeutral ? 1 : 0);
                reported("sent", sent, now);
                reported("came", came, now);
            }
            moved = moves;
        }
        EXPECT_FALSE(m_station->streamer().status().needsNeutral) << "it is driven no more: the station hung";
        const auto counts = m_robot->commands().counts();
        std::printf(
            "%lld s at 5 %% loss and 20 ms of jitter: %llu commands came, %llu refused, %d stutters, "
            "and %d while the station was late itself\n",
            static_cast<long long>(duration.count()), static_cast<unsigned long long>(counts.taken),
            static_cast<unsigned long long>(counts.refused), count, late);
        return count;
    }

    const TestDomain m_domain;
    const RobotDescription m_description = drivenRobot();
    std::optional<RadioLink> m_radio;
    std::unique_ptr<Node> m_there, m_here;
    std::unique_ptr<ControlRobot> m_robot;
    std::unique_ptr<ControlStation> m_station;
};
using DriveOverRadioLong = DriveOverRadio;
using LongDriveOverRadioLatency = DriveOverRadio;

TEST_F(LongDriveOverRadioLatency, AMinuteIsDrivenWithOneStutterAtMost) {
    EXPECT_LE(stutters(60s), 1);
}

TEST_F(DriveOverRadioLong, TenMinutesAreDrivenWithOneStutterAtMost) {
    EXPECT_LE(stutters(600s), 1);
}

}  // namespace
}  // namespace leitstand::test
