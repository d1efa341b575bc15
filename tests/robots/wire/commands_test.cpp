#include <cmath>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/event/command_samples.h"
#include "core/event/motion_samples.h"
#include "core/event/sample.h"
#include "core/event/station_samples.h"
#include "core/event/stream_role.h"
#include "robots/agent/robot_agent.h"
#include "tests/robots/wire/wire_station.h"
#include "tests/support/fake_robot.h"
#include "transport/link/grant_sender.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;

class WireCommands : public testing::Test {
protected:
    /// All that came until @p enough did.
    template <class Enough>
    std::vector<ReceivedCommand> takeUntil(Enough enough) {
        std::vector<ReceivedCommand> all;
        EXPECT_TRUE(waitUntil([&] {
            for (ReceivedCommand& one : m_wire->take()) all.push_back(std::move(one));
            return enough(all);
        }));
        return all;
    }
    const TestDomain m_domain;
    const RobotDescription m_robot = fileOf("crawler");
    std::unique_ptr<Node> m_there = nodeIn(m_domain), m_here = nodeIn(m_domain);
    std::unique_ptr<RobotWire> m_wire = must(RobotWire::create(*m_there, m_robot));
};

TEST_F(WireCommands, AllComeAsTheyWereSaidAndFromWhom) {
    for (const char* name : {"crawler", "kurt3d"}) {
        const RobotDescription robot = fileOf(name);
        const auto wire = must(RobotWire::create(*m_there, robot));
        WireStation station(*m_here, robot);
        ASSERT_TRUE(station.matched());
        for (const StreamDescription& stream : robot.streams) {
            if (!isCommand(stream.role)) continue;
            const Sample sample = sampleFor(stream);
            std::optional<ReceivedCommand> received;
            EXPECT_TRUE(waitUntil([&] {
                station.publish(stream, sample);
                for (ReceivedCommand& one : wire->take()) {
                    if (one.role == stream.role)
                        received = std::move(one);  // repetitions of others come late
                }
                return received.has_value();
            })) << stream.topic;
            ASSERT_TRUE(received) << stream.topic;
            EXPECT_EQ(received->role, stream.role);
            EXPECT_FALSE(received->grant);
            EXPECT_EQ(*must(encode(received->sample, stream.type)), *must(encode(sample, stream.type)));
            EXPECT_EQ(received->from, senderOf(station.on(stream.topic).guid()));
        }
    }
}

TEST_F(WireCommands, GrantsComeWithTheCommandsInOrderAndFromTheSameSender) {
    WireStation station(*m_here, m_robot);
    ASSERT_TRUE(station.matched());
    GrantSample grant;
    grant.station = "a";
    grant.robot = "crawler";
    StreamDescription grants;
    grants.topic = station_topic::Grants;
    grants.type = "leitstand_msgs/msg/Grant";
    const auto all = takeUntil([&](const auto& received) {
        station.publish(grants, grant);
        station.publish(*m_robot.stream(StreamRole::DriveCommand), TwistSample{});
        return std::any_of(received.begin(), received.end(), [](const auto& one) { return one.grant; }) &&
               std::any_of(received.begin(), received.end(), [](const auto& one) { return !one.grant; });
    });
    for (const ReceivedCommand& one : all) {
        EXPECT_EQ(one.from, all.front().from) << "one process";
        if (!one.grant) continue;
        EXPECT_EQ(one.sample.get<GrantSample>().station, "a");
    }
}

TEST_F(WireCommands, HostileBytesAreCountedAndStopDrivingAndNothingElse) {
    WireStation station(*m_here, m_robot);
    ASSERT_TRUE(station.matched());
    std::mt19937 random(7);
    const std::string drive = m_robot.stream(StreamRole::DriveCommand)->topic;
    for (auto& [topic, publisher] : station.all()) {
        // Cut, with counts beyond all bounds, and noise.
        std::vector<std::vector<std::byte>> hostile = {
            {std::byte{0}, std::byte{1}, std::byte{0}, std::byte{0}}};
        hostile.emplace_back(64, std::byte{0xFF});
        hostile.back()[0] = std::byte{0};
        hostile.back()[1] = std::byte{1};
        for (int i = 0; i < 8; ++i) {
            std::vector<std::byte> noise(8 + random() % 200);
            for (std::byte& one : noise) one = static_cast<std::byte>(random());
            noise[0] = std::byte{0};
            noise[1] = std::byte{1};
            // Counts that follow are huge: no string of that length is there.
            for (std::size_t at = 4; at < std::min<std::size_t>(noise.size(), 8); ++at)
                noise[at] = std::byte{0x7F};
            hostile.push_back(std::move(noise));
        }
        for (const auto& bytes : hostile) {
            const std::uint64_t before = m_wire->counts().broken;
            const bool counted = waitUntil(
                [&] {
                    static_cast<void>(
                        publisher->write(std::make_shared<const std::vector<std::byte>>(bytes)));
                    return m_wire->counts().broken > before;
                },
                topic == drive ? 200ms : 20s);
            // Noise may be a Twist: any six numbers are one.
            EXPECT_TRUE(counted || topic == drive) << topic << ", " << bytes.size() << " bytes";
            for (const ReceivedCommand& received : m_wire->take()) {
                EXPECT_FALSE(received.grant);
                ASSERT_TRUE(received.role == StreamRole::DriveCommand ||
                            received.role == StreamRole::TrackCommand)
                    << topic;
                if (received.role != StreamRole::TrackCommand) continue;
                const auto* twist = received.sample.as<TwistSample>();
                ASSERT_NE(twist, nullptr);
                EXPECT_FALSE(twist->linear.allFinite()) << "no number: it stops";
            }
        }
    }
    EXPECT_GT(m_wire->counts().broken, 50u);
    // It hears on.
    const StreamDescription& ping = *m_robot.stream(StreamRole::Ping);
    takeUntil([&](const auto& received) {
        station.publish(ping, PingSample{20, "a", Time{}});
        return std::any_of(received.begin(), received.end(), [](const auto& one) {
            const auto* found = one.sample.template as<PingSample>();
            return found != nullptr && found->number == 20;
        });
    });
}

TEST_F(WireCommands, AFloodIsDroppedButNeverAStop) {
    WireStation station(*m_here, m_robot);
    ASSERT_TRUE(station.matched());
    const StreamDescription &ping = *m_robot.stream(StreamRole::Ping),
                            &stop = *m_robot.stream(StreamRole::StopCommand);
    std::uint64_t number = 0;
    ASSERT_TRUE(waitUntil(
        [&] {
            for (int i = 0; i < 20; ++i) station.publish(ping, PingSample{++number, "flood", Time{}});
            return m_wire->counts().dropped > 0;
        },
        60s));
    const std::uint64_t before = m_wire->counts().accepted;
    ASSERT_TRUE(waitUntil([&] {
        station.publish(stop, StopCommandSample{{}, "a", 77, true, 0});
        return m_wire->counts().accepted > before + 20;
    }));
    const auto all = m_wire->take();
    EXPECT_GE(all.size(), 1'000u);
    EXPECT_TRUE(std::any_of(all.begin(), all.end(), [](const ReceivedCommand& one) {
        const auto* found = one.sample.as<StopCommandSample>();
        return found != nullptr && found->number == 77;
    }));
}

TEST_F(WireCommands, ThroughTheAgentTheyReachTheHardwareAndAreAnswered) {
    FakeRobot hardware;
    RobotAgent agent(hardware, m_robot, {});
    WireStation station(*m_here, m_robot);
    RobotListener published(*m_here, m_robot);
    ASSERT_TRUE(station.matched());
    const auto turn = [&] {
        for (const ReceivedCommand& received : m_wire->take()) {
            if (received.grant) {
                agent.receive(received.sample.get<GrantSample>(), received.from);
            } else {
                agent.receive(received.role, received.sample, received.from);
            }
        }
        hardware.time += 10ms;
        for (const HardwareSample& sample : agent.step()) m_wire->publish(sample);
    };
    const StreamDescription& settings = *m_robot.stream(StreamRole::StreamCommand);
    const std::string omni = "/crawler/omni/image/compressed";
    EXPECT_TRUE(waitUntil([&] {
        station.publish(settings, StreamCommandSample{{}, "a", omni, true, 2.5, 30, 160});
        turn();
        return hardware.streams.contains({StreamRole::Picture, "omni"});
    }));
    const StreamSettings set = hardware.streams.at({StreamRole::Picture, "omni"});
    EXPECT_TRUE(set.enabled);
    EXPECT_DOUBLE_EQ(set.rate, 2.5);
    EXPECT_EQ(set.quality, 30);
    EXPECT_EQ(set.maxWidth, 160);
    EXPECT_TRUE(waitUntil([&] {
        station.publish(*m_robot.stream(StreamRole::Ping), PingSample{9, "a", Time(5s)});
        turn();
        return published.count("/crawler/pong") > 0;
    }));
    EXPECT_EQ(published.all<PongSample>("/crawler/pong").front().sent, Time(5s));
    EXPECT_TRUE(waitUntil([&] {
        station.publish(*m_robot.stream(StreamRole::StopCommand), StopCommandSample{{}, "a", 12, true, 0});
        turn();
        const auto states = published.all<StopStateSample>("/crawler/stop_state");
        return !states.empty() && states.back().number == 12 && states.back().stopped;
    }));
}

}  // namespace
}  // namespace leitstand::test
