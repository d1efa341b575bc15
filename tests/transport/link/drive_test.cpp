#include <algorithm>
#include <csignal>
#include <cstdio>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/event/motion_samples.h"
#include "core/event/sample.h"
#include "core/event/stream_role.h"
#include "core/robot/streams/stream_defaults.h"
#include "tests/support/child_process.h"
#include "tests/support/places.h"
#include "tests/transport/link/control_robot.h"
#include "tests/transport/link/control_station.h"
#include "transport/convert/decode.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;
using Milliseconds = std::chrono::duration<double, std::milli>;

/// What goes over the wire to the robot, and when.
class Wire {
public:
    Wire(Node& node, const StreamDescription& stream)
        : m_subscription(
              must(node.subscribe({stream.topic, stream.type, stream.qos}, [this, stream](auto sample) {
                  const auto decoded = must(decode(sample.event, stream));
                  const std::scoped_lock lock(m_mutex);
                  m_samples.push_back({Clock::now(), decoded});
              }))) {}
    struct Command {
        Clock::time_point at;
        Sample sample;
        [[nodiscard]] double speed() const { return sample.get<TwistSample>().linear.x(); }
    };
    [[nodiscard]] std::vector<Command> commands() const {
        const std::scoped_lock lock(m_mutex);
        return m_samples;
    }
    [[nodiscard]] std::size_t size() const { return commands().size(); }
    [[nodiscard]] std::optional<Command> last() const {
        const auto all = commands();
        return all.empty() ? std::nullopt : std::optional(all.back());
    }
    void forget() {
        const std::scoped_lock lock(m_mutex);
        m_samples.clear();
    }

private:
    mutable std::mutex m_mutex;
    std::vector<Command> m_samples;
    std::unique_ptr<Subscription> m_subscription;  ///< last: it calls back
};

/// Times between commands [ms], sorted.
std::vector<double> gaps(const std::vector<Wire::Command>& commands) {
    std::vector<double> all;
    for (std::size_t i = 1; i < commands.size(); ++i) {
        all.push_back(Milliseconds(commands[i].at - commands[i - 1].at).count());
    }
    std::sort(all.begin(), all.end());
    return all;
}

/// A streamer that is always permitted, and its wire.
class Drive : public testing::Test {
protected:
    void start(const RobotDescription& robot, StreamRole role = StreamRole::DriveCommand,
               DriveStreamerSettings settings = {}) {
        settings.conditions = [this] { return DriveConditions{m_may.load(), m_hold.load()}; };
        m_streamer = must(DriveStreamer::create(*m_node, robot, settings));
        m_wire = std::make_unique<Wire>(*m_robotNode, *robot.stream(role));
        m_streamer->setFocus(true);
        // Matched, and neutral once.
        ASSERT_TRUE(waitUntil([&] {
            m_streamer->set({});
            return m_wire->size() > 0 && !m_streamer->status().needsNeutral;
        }));
    }
    /// Tells the stick at 50 Hz or more until @p condition holds.
    template <class Condition>
    bool pushUntil(double speed, Condition condition, std::chrono::milliseconds atMost = 20s) {
        return waitUntil(
            [&] {
                m_streamer->set({speed, 0.0, 0.0});
                return condition();
            },
            atMost);
    }
    const TestDomain m_domain;
    std::atomic<bool> m_may = true, m_hold = false;
    std::unique_ptr<Node> m_robotNode = nodeIn(m_domain), m_node = nodeIn(m_domain);
    std::unique_ptr<Wire> m_wire;
    std::unique_ptr<DriveStreamer> m_streamer;
};
using DriveLatency = Drive;

TEST_F(DriveLatency, CommandsComeAtFortyHertzAndChangesAtOnce) {
    start(drivenRobot());
    ASSERT_TRUE(pushUntil(0.3, [&] { return m_wire->last()->speed() == 0.3; }));
    m_wire->forget();
    const auto begin = Clock::now();
    ASSERT_TRUE(pushUntil(0.3, [&] { return Clock::now() - begin >= 5s; }));
    const auto all = gaps(m_wire->commands());
    ASSERT_GT(all.size(), 50U);
    std::printf("repeated: %zu commands in 5 s; between them p50 %.1f ms, p99 %.1f ms, worst %.1f ms\n",
                all.size() + 1, all[all.size() / 2], all[all.size() * 99 / 100], all.back());
    EXPECT_GE(all.size() + 1, 180U);
    EXPECT_LE(all.size() + 1, 220U);
    EXPECT_NEAR(all[all.size() / 2], 25.0, 5.0);
    EXPECT_LT(all.back(), 200.0);

    std::vector<double> delays;
    for (int i = 1; i <= 40; ++i) {
        const double speed = 0.01 * i;
        const auto reported = Clock::now();
        m_streamer->set({speed, 0.0, 0.0});
        ASSERT_TRUE(waitUntil([&] { return m_wire->last()->speed() == speed; }));
        delays.push_back(Milliseconds(m_wire->last()->at - reported).count());
    }
    std::sort(delays.begin(), delays.end());
    std::printf("changes: on the wire's other end after p50 %.1f ms, worst %.1f ms\n",
                delays[delays.size() / 2], delays.back());
    EXPECT_LT(delays[delays.size() / 2], 15.0) << "not with the next repetition";
}

TEST_F(DriveLatency, ASetpointOlderThanTwoHundredMillisecondsBecomesZero) {
    start(drivenRobot());
    for (int i = 0; i < 5; ++i) {
        ASSERT_TRUE(pushUntil(0.3, [&] { return m_wire->last()->speed() == 0.3; }));
        m_streamer->set({0.3, 0.0, 0.0});
        const auto last = Clock::now();
        ASSERT_TRUE(waitUntil([&] { return m_wire->last()->speed() == 0.0; }));
        const double took = Milliseconds(m_wire->last()->at - last).count();
        std::printf("the window hangs: zero after %.0f ms\n", took);
        EXPECT_GT(took, 150.0);
        EXPECT_LT(took, 300.0);
    }
}

TEST_F(Drive, NoStickGoesRoundWhatTheDriverSees) {
    std::atomic<double> factor = 1.0;
    DriveStreamerSettings settings;
    settings.sight = [&factor](const DriveVelocity&, bool withoutEyes) {
        SightCap cap;
        cap.overridden = withoutEyes;
        cap.factor = withoutEyes ? 1.0 : factor.load();
        cap.reason = factor < 1.0 ? SightReason::OldPicture : SightReason::Fresh;
        return cap;
    };
    start(drivenRobot(), StreamRole::DriveCommand, settings);
    const auto speed = [&] { return m_wire->last()->speed(); };
    ASSERT_TRUE(pushUntil(0.3, [&] { return speed() == 0.3; }));
    factor = 0.2;
    ASSERT_TRUE(pushUntil(0.3, [&] { return speed() == 0.1; })) << "a fifth of what the robot can";
    EXPECT_EQ(m_streamer->status().sight.reason, SightReason::OldPicture);
    factor = 0.0;
    ASSERT_TRUE(pushUntil(0.3, [&] { return speed() == 0.0; }));
    factor = 1.0;
    ASSERT_FALSE(pushUntil(
        0.3, [&] { return speed() != 0.0; }, 300ms))
        << "it never moves on by itself";
    EXPECT_TRUE(m_streamer->status().needsNeutral);
    ASSERT_TRUE(pushUntil(0.0, [&] { return !m_streamer->status().needsNeutral; }));
    ASSERT_TRUE(pushUntil(0.3, [&] { return speed() == 0.3; }));

    // The override, as long as it is told.
    factor = 0.0;
    ASSERT_TRUE(pushUntil(0.0, [&] { return speed() == 0.0 && !m_streamer->status().needsNeutral; }));
    ASSERT_TRUE(waitUntil([&] {
        m_streamer->set({0.3, 0.0, 0.0}, true);
        return speed() == 0.3;
    }));
    EXPECT_TRUE(m_streamer->status().sight.overridden);
    ASSERT_TRUE(pushUntil(0.3, [&] { return speed() == 0.0; })) << "let go";
    EXPECT_FALSE(m_streamer->status().sight.overridden);
}

TEST_F(Drive, OnlyReadersOfOtherProcessesAreListeners) {
    start(drivenRobot());
    EXPECT_EQ(m_streamer->listeners(), 1);
    const StreamDescription stream = *drivenRobot().stream(StreamRole::DriveCommand);
    const auto recorder = must(m_node->subscribe({stream.topic, stream.type, stream.qos}, [](auto) {}));
    ASSERT_TRUE(waitUntil([&] { return recorder->counts().writers == 1; })) << "it hears the same station";
    EXPECT_EQ(m_streamer->listeners(), 1);
    m_wire.reset();
    EXPECT_TRUE(waitUntil([&] { return m_streamer->listeners() == 0; })) << "nobody but the recorder";
    ASSERT_TRUE(pushUntil(0.0, [&] { return m_streamer->status().listeners == 0; }));
}

TEST_F(Drive, WhatTheGuardIsToldFollowsTheCommands) {
    std::mutex mutex;
    std::vector<std::pair<Clock::time_point, bool>> pulses;
    DriveStreamerSettings settings;
    settings.onPulse = [&](const GuardPulse& pulse) {
        const std::scoped_lock lock(mutex);
        pulses.emplace_back(Clock::now(), pulse.driving);
    };
    const auto newest = [&] {
        const std::scoped_lock lock(mutex);
        return pulses.empty() ? std::nullopt : std::optional(pulses.back().second);
    };
    start(drivenRobot(), StreamRole::DriveCommand, settings);
    ASSERT_TRUE(pushUntil(0.3, [&] { return m_wire->last()->speed() == 0.3; }));
    EXPECT_EQ(newest(), true);
    m_streamer->setFocus(false);
    ASSERT_TRUE(waitUntil([&] { return newest() == false; }));
    EXPECT_EQ(m_wire->last()->speed(), 0.0);
    m_streamer.reset();
    const std::scoped_lock lock(mutex);
    EXPECT_GE(std::count_if(pulses.begin(), pulses.end(), [](const auto& one) { return one.second; }), 20)
        << "its zeros are guarded too";
    EXPECT_FALSE(pulses.back().second);
}

TEST_F(Drive, HaltedItStandsUntilTheSticksWereNeutral) {
    start(drivenRobot());
    ASSERT_TRUE(pushUntil(0.3, [&] { return m_wire->last()->speed() == 0.3; }));
    m_streamer->halt();
    ASSERT_TRUE(pushUntil(0.3, [&] { return m_wire->last()->speed() == 0.0; }));
    ASSERT_FALSE(pushUntil(
        0.3, [&] { return m_wire->last()->speed() != 0.0; }, 300ms));
    ASSERT_TRUE(pushUntil(0.0, [&] { return !m_streamer->status().needsNeutral; }));
    ASSERT_TRUE(pushUntil(0.3, [&] { return m_wire->last()->speed() == 0.3; }));
}

TEST_F(Drive, WithoutFocusOrGrantItIsZeroAtOnceAndThenSilent) {
    start(drivenRobot());
    ASSERT_TRUE(pushUntil(0.3, [&] { return m_wire->last()->speed() == 0.3; }));
    m_streamer->setFocus(false);
    ASSERT_TRUE(pushUntil(0.3, [&] { return m_wire->last()->speed() == 0.0; }));
    const auto silent = [&] { return Clock::now() - m_wire->last()->at > 1s; };
    ASSERT_TRUE(pushUntil(0.3, silent)) << "it still speaks";
    m_streamer->setFocus(true);
    ASSERT_TRUE(pushUntil(0.3, [&] { return m_streamer->status().needsNeutral; }));
    EXPECT_EQ(m_wire->last()->speed(), 0.0) << "the stick was not neutral";
    ASSERT_TRUE(pushUntil(0.0, [&] { return !m_streamer->status().needsNeutral; }));
    ASSERT_TRUE(pushUntil(0.3, [&] { return m_wire->last()->speed() == 0.3; }));
    m_may = false;
    m_streamer->refresh();
    ASSERT_TRUE(pushUntil(0.3, [&] { return m_wire->last()->speed() == 0.0; }));
    m_wire->forget();
    ASSERT_TRUE(waitUntil([&] { return m_wire->size() > 0 && silent(); }));
    const auto zeros = m_wire->commands();
    EXPECT_LE(zeros.size(), 40U);
    EXPECT_TRUE(std::all_of(zeros.begin(), zeros.end(), [](const auto& one) { return one.speed() == 0.0; }));
    m_hold = true;
    ASSERT_TRUE(waitUntil([&] { return m_wire->size() > zeros.size() + 45; }))
        << "zeros that hold a robot go on";
}

// Readers that do not read: one hangs on the same node, one is a reliable process that was stopped.
TEST_F(DriveLatency, NobodyElseHoldsUpDriving) {
    std::atomic<bool> over = false;
    start(drivenRobot());
    const StreamDescription stream = *drivenRobot().stream(StreamRole::DriveCommand);
    const auto full = must(m_node->subscribe({stream.topic, stream.type, stream.qos, Lane::Large}, [&](auto) {
        static_cast<void>(waitUntil([&] { return over.load(); }, 60s));
    }));
    const auto points =
        must(m_node->subscribe({"/kurt3d/points", TestType, reliable(600), Lane::Small}, [&](auto) {
            static_cast<void>(waitUntil([&] { return over.load(); }, 60s));
        }));
    const auto scanner =
        must(m_robotNode->publisher({"/kurt3d/points", TestType, reliable(600), Flow::Scans}));
    const ChildProcess stuck(program("control_peer"),
                             {"listen", std::to_string(m_domain.number()), stream.topic, stream.type});
    ASSERT_TRUE(pushUntil(0.3, [&] { return stuck.out().find("heard") != std::string::npos; }));
    stuck.signal(SIGSTOP);
    for (std::uint32_t i = 0; i < 100; ++i) ASSERT_TRUE(scanner->write(testPayload(50'000, i)));
    m_wire->forget();
    const auto begin = Clock::now();
    ASSERT_TRUE(pushUntil(0.3, [&] { return Clock::now() - begin >= 5s; }));
    const auto all = gaps(m_wire->commands());
    ASSERT_FALSE(all.empty());
    std::printf("beside readers that hang: %zu commands in 5 s, worst gap %.1f ms\n", all.size() + 1,
                all.back());
    EXPECT_GE(all.size() + 1, 90U);
    EXPECT_LT(all.back(), 250.0);
    over = true;
}

TEST_F(Drive, TheRobotStopsWhenTheStationIsGone) {
    const RobotDescription description = drivenRobot();
    ControlRobot robot(*m_robotNode, description);
    const ChildProcess station(program("control_peer"),
                               {"station", std::to_string(m_domain.number()), "b", "5", "0.3"});
    ASSERT_TRUE(waitUntil([&] { return robot.speed() > 0.0; })) << station.out();
    const auto killed = Clock::now();
    station.signal(SIGKILL);
    ASSERT_TRUE(waitUntil([&] { return robot.speed() == 0.0; }));
    const double took = Milliseconds(Clock::now() - killed).count();
    std::printf("station killed: the robot stands after %.0f ms\n", took);
    EXPECT_LE(took, 300.0);
}

TEST_F(Drive, StampsAreWhoseTheRobotsFileSays) {
    struct Case {
        StampSource source;
        std::chrono::nanoseconds off;
    };
    for (const Case& one : {Case{StampSource::Robot, 5s}, {StampSource::Station, 0s}}) {
        RobotDescription robot = drivenRobot();
        robot.streams[1].type = "geometry_msgs/msg/TwistStamped";
        robot.streams[1].stamp = one.source;
        DriveStreamerSettings settings;
        settings.clockAhead = [] { return 5s; };
        start(robot, StreamRole::DriveCommand, settings);
        const auto command = m_wire->last()->sample.get<TwistSample>();
        ASSERT_TRUE(command.stamp);
        const auto off = *command.stamp - std::chrono::system_clock::now();
        EXPECT_LT(std::chrono::abs(off - one.off), 2s);
        EXPECT_EQ(command.frame, "base_link");
    }
    RobotDescription robot = drivenRobot();
    robot.streams[1].type = "geometry_msgs/msg/TwistStamped";
    robot.streams[1].stamp = StampSource::Zero;
    start(robot);
    EXPECT_FALSE(m_wire->last()->sample.get<TwistSample>().stamp);
}

TEST_F(Drive, TracksAreDrivenWhereThereIsNothingElse) {
    RobotDescription robot = drivenRobot();
    robot.streams[1] = defaultStream(StreamRole::TrackCommand, "kurt3d", {});
    ControlRobot moving(*m_robotNode, robot);
    start(robot, StreamRole::TrackCommand);
    const auto keeper = must(GrantKeeper::create(*m_node, {"a", "Left desk", {{driveGrant("kurt3d"), 5}}}));
    ASSERT_TRUE(waitUntil([&] { return moving.commands().holder() == "a"; }));
    ASSERT_TRUE(pushUntil(0.0, [&] { return moving.commands().counts().taken > 0; }));
    ASSERT_TRUE(waitUntil([&] {
        m_streamer->set({0.2, 0.0, 0.5});
        const DriveVelocity velocity = moving.commands().commanded();
        return std::abs(velocity.forward - 0.2) < 1e-9 && std::abs(velocity.turn - 0.5) < 1e-9;
    }));
    const auto command = m_wire->last()->sample.get<TrackCommand>();
    EXPECT_EQ(command.names, (std::vector<std::string>{"left_track", "right_track"}));
}

TEST_F(Drive, WhatCannotBeDrivenIsSaid) {
    RobotDescription robot = drivenRobot();
    robot.streams.erase(robot.streams.begin() + 1);
    const auto none = DriveStreamer::create(*m_node, robot, {});
    ASSERT_FALSE(none.ok());
    EXPECT_NE(none.error().text.find("drive_command"), std::string::npos);
    EXPECT_FALSE(RobotCommands::create(*m_node, robot).ok());
    robot.streams.push_back(defaultStream(StreamRole::TrackCommand, "kurt3d", {}));
    robot.footprint.clear();
    EXPECT_FALSE(DriveStreamer::create(*m_node, robot, {}).ok());
    robot = drivenRobot();
    robot.streams[1].type = "std_msgs/msg/Float32";
    const auto wrong = DriveStreamer::create(*m_node, robot, {});
    ASSERT_FALSE(wrong.ok());
    EXPECT_NE(wrong.error().text.find("/kurt3d/cmd_vel"), std::string::npos);
}

}  // namespace
}  // namespace leitstand::test
