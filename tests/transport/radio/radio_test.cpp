#include <algorithm>
#include <cstdio>
#include <optional>
#include <set>

#include <gtest/gtest.h>

#include "tests/support/child_process.h"
#include "tests/support/latency.h"
#include "tests/support/net/radio_link.h"
#include "tests/support/places.h"
#include "tests/transport/dds/test_node.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;

/// What a robot said at its end.
struct RobotReport {
    unsigned points = 0, odom = 0;
    std::size_t commands = 0;
    double p50 = 0.0, p99 = 0.0, worst = 0.0;
};

/// One robot behind the radio link and what the station hears of it.
class RobotLink {
public:
    RobotLink(Node& station, const RadioLink& radio, int domain, const std::string& name, int seconds,
              const std::vector<std::string>& options, bool transientPoints)
        : m_name(name) {
        const std::string prefix = "/" + name + "/";
        const auto listen = [&](const std::string& topic, const Qos& qos, Lane lane,
                                SampleCallback callback) {
            m_subscriptions.push_back(
                must(station.subscribe({prefix + topic, TestType, qos, lane}, std::move(callback))));
        };
        listen("points", transientPoints ? transientLocal(600) : reliable(600), Lane::Large,
               [this](auto sample) {
                   const std::scoped_lock lock(m_mutex);
                   const std::chrono::duration<double> delay = sample.event.received - sample.sourceTime;
                   m_points.insert(seedOf(sample));
                   m_pointDelays.push_back(delay.count());
               });
        listen("odom", bestEffort(), Lane::Small, [this](auto sample) {
            const std::chrono::duration<double, std::milli> delay = sample.event.received - sample.sourceTime;
            const std::scoped_lock lock(m_mutex);
            m_odometryDelays.push_back(delay.count());
        });
        for (const char* topic : {"imu", "tf"}) listen(topic, bestEffort(), Lane::Small, [](auto) {});
        for (const char* topic : {"left", "ir", "omni"}) {
            listen(std::string(topic) + "/image/compressed", bestEffort(), Lane::Large,
                   [this](auto) { ++m_pictures; });
        }
        Qos command;
        command.lifespan = 0.2;
        m_commands = must(station.publisher({prefix + "cmd_vel", TestType, command, Flow::Immediate}));
        const InNamespace there(radio.robots());
        std::vector<std::string> words = {std::to_string(domain), name, std::to_string(seconds)};
        words.insert(words.end(), options.begin(), options.end());
        m_process = std::make_unique<ChildProcess>(program("radio_robot"), words);
    }

    [[nodiscard]] bool reported(const std::string& word) const {
        return m_process->out().find(word) != std::string::npos;
    }
    void command() { static_cast<void>(m_commands->write(testPayload(60, ++m_commandsSent))); }
    [[nodiscard]] std::size_t points() const {
        const std::scoped_lock lock(m_mutex);
        return m_points.size();
    }
    [[nodiscard]] RobotReport report() const {
        RobotReport reported;
        const std::string out = m_process->out();
        const auto begin = out.find("points ");
        if (begin == std::string::npos) return reported;
        std::sscanf(out.c_str() + begin, "points %u odom %u commands %zu p50 %lf p99 %lf worst %lf",
                    &reported.points, &reported.odom, &reported.commands, &reported.p50, &reported.p99,
                    &reported.worst);
        return reported;
    }
    [[nodiscard]] double odometryP99() const {
        const std::scoped_lock lock(m_mutex);
        return quantile(m_odometryDelays, 0.99);
    }
    void print() const {
        const std::scoped_lock lock(m_mutex);
        const RobotReport reported = report();
        std::printf(
            "%s: points %zu of %u (%zu twice): p50 %.2f s, p99 %.2f s, odometry %zu of %u: p50 %.1f ms, p99 "
            "%.1f ms, commands %zu of "
            "%u: p50 %.1f ms, p99 %.1f ms, worst %.1f ms, pictures %d\n",
            m_name.c_str(), m_points.size(), reported.points, m_pointDelays.size() - m_points.size(),
            quantile(m_pointDelays, 0.5), quantile(m_pointDelays, 0.99), m_odometryDelays.size(),
            reported.odom, quantile(m_odometryDelays, 0.5), quantile(m_odometryDelays, 0.99),
            reported.commands, m_commandsSent, reported.p50, reported.p99, reported.worst, m_pictures.load());
    }

private:
    std::string m_name;
    mutable std::mutex m_mutex;
    std::set<std::uint32_t> m_points;
    std::vector<double> m_pointDelays;     // [s]
    std::vector<double> m_odometryDelays;  // [ms]
    std::atomic<int> m_pictures = 0;
    std::uint32_t m_commandsSent = 0;
    std::vector<std::unique_ptr<Subscription>> m_subscriptions;
    std::unique_ptr<Publisher> m_commands;
    std::unique_ptr<ChildProcess> m_process;
};

/// A station and two robots with the streams of design section 4 on a link of 10 Mbit/s, 20 ms, 5 % loss.
class Radio : public testing::Test {
protected:
    void SetUp() override {
        if (const std::string why = whyNoNamespaces(); !why.empty()) {
            GTEST_SKIP() << "SKIPPED: the radio link needs network namespaces and TUN: " << why;
        }
        m_radio.emplace();
        m_here.emplace(m_radio->station());
    }
    void start(int seconds, NodeSettings settings = {}, bool transientPoints = false) {
        m_station = nodeIn(m_domain, settings);
        std::vector<std::string> options = {"lease=" + std::to_string(static_cast<int>(settings.lease))};
        if (transientPoints) options.emplace_back("transient");
        for (const char* name : {"kurt3d", "crawler"}) {
            m_robots.push_back(std::make_unique<RobotLink>(*m_station, *m_radio, m_domain.number(), name,
                                                           seconds, options, transientPoints));
        }
        ASSERT_TRUE(waitUntil([&] { return all("begin"); })) << "the robots were not found over the link";
    }
    [[nodiscard]] bool all(const std::string& word) const {
        return std::all_of(m_robots.begin(), m_robots.end(),
                           [&](const auto& robot) { return robot->reported(word); });
    }
    /// Sends commands at 20 Hz until @p condition holds.
    template <class Condition>
    bool driveUntil(Condition condition, std::chrono::milliseconds atMost) {
        auto next = std::chrono::steady_clock::now();
        return waitUntil(
            [&] {
                if (std::chrono::steady_clock::now() >= next) {
                    for (const auto& robot : m_robots) robot->command();
                    next += 50ms;
                }
                return condition();
            },
            atMost);
    }
    void expectAllPoints(std::chrono::milliseconds atMost) {
        const auto complete = [&] {
            return std::all_of(m_robots.begin(), m_robots.end(), [](const auto& robot) {
                return robot->report().points > 0 && robot->points() >= robot->report().points;
            });
        };
        EXPECT_TRUE(waitUntil(complete, atMost)) << "slices are missing";
        for (const auto& robot : m_robots) {
            robot->print();
            EXPECT_EQ(robot->points(), robot->report().points);
        }
        std::printf("radio: %.1f MB delivered, %llu packets dropped by full queues\n",
                    1e-6 * static_cast<double>(m_radio->bytes()),
                    static_cast<unsigned long long>(m_radio->congested()));
    }
    /// Lets the streams run for two seconds, breaks the link for @p gap, and lets them end.
    void driveThroughAGap(std::chrono::seconds gap) {
        ASSERT_TRUE(waitUntil([&] { return m_robots[0]->points() >= 20 && m_robots[1]->points() >= 20; }));
        m_radio->setOutage(true);
        const auto end = std::chrono::steady_clock::now() + gap;
        EXPECT_FALSE(driveUntil([&] { return std::chrono::steady_clock::now() > end + 1h; }, gap));
        m_radio->setOutage(false);
        EXPECT_TRUE(driveUntil([&] { return all("end"); }, 60s));
        expectAllPoints(60s);
    }

    TestDomain m_domain;
    std::optional<RadioLink> m_radio;
    std::optional<InNamespace> m_here;
    std::unique_ptr<Node> m_station;
    std::vector<std::unique_ptr<RobotLink>> m_robots;
};

using RadioLatency = Radio;
using RadioLong = Radio;

TEST_F(RadioLatency, OdometryAndCommandsAreQuickAndEverySliceArrives) {
    constexpr double AskedMilliseconds = 60.0;
    start(15);
    EXPECT_TRUE(driveUntil([&] { return all("end"); }, 30s));
    expectAllPoints(20s);
    std::printf("p99 asked of odometry and commands: %.0f ms\n", AskedMilliseconds);
    for (const auto& robot : m_robots) {
        EXPECT_GT(robot->report().commands, 200U);
        EXPECT_LT(robot->report().p99, Generous * AskedMilliseconds);
        EXPECT_LT(robot->odometryP99(), Generous * AskedMilliseconds);
    }
}

TEST_F(Radio, NoSliceIsLostInAGapOf6Seconds) {
    start(12);
    driveThroughAGap(6s);
}

TEST_F(RadioLong, NoSliceIsLostInAGapOf30Seconds) {
    start(40);
    driveThroughAGap(30s);
}

TEST_F(RadioLong, TransientLocalSlicesOutlastEvenTheLease) {
    NodeSettings settings;
    settings.lease = 20.0;
    start(40, settings, true);
    driveThroughAGap(30s);
}

}  // namespace
}  // namespace leitstand::test
