#include <array>
#include <chrono>
#include <cmath>
#include <thread>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include "core/event/motion_samples.h"
#include "core/event/stream_role.h"
#include "tests/transport/link/control_robot.h"
#include "tests/transport/link/control_station.h"
#include "transport/convert/decode.h"
#include "transport/link/drive_guard.h"
#include "transport/link/grant_sender.h"
#include "transport/link/guard_arguments.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;

GuardArguments someArguments() {
    GuardArguments arguments;
    arguments.network.domain = 42;
    arguments.network.interfaces = {"lo", "wlan0"};
    arguments.network.initialPeers = {"192.168.0.7"};
    arguments.network.discoveryServer = "192.168.0.1:11811";
    arguments.keys = "/home/a b/enclaves/station1";
    arguments.guard.robot = "kurt3d";
    arguments.guard.station = "0123-abc";
    arguments.guard.driver.bytes = {0, 1, 2, 3, 4, 5, 6, 7, 8, 250, 251, 255};
    arguments.guard.message = must(driveMessageFor(drivenRobot()));
    arguments.guard.message.stream.stamp = StampSource::Station;
    arguments.guard.message.leftTrack = "l";
    return arguments;
}

TEST(GuardArguments, AreReadAsTheyWereWritten) {
    const GuardArguments written = someArguments();
    const GuardArguments read = must(guardArgumentsFrom(wordsOf(written)));
    EXPECT_EQ(wordsOf(read), wordsOf(written));
    EXPECT_EQ(read.guard.driver.bytes, written.guard.driver.bytes);
    EXPECT_EQ(read.network.interfaces, written.network.interfaces);
    EXPECT_EQ(read.keys, written.keys);
    EXPECT_EQ(read.guard.message.stream.topic, written.guard.message.stream.topic);
    EXPECT_EQ(read.guard.message.stream.type, written.guard.message.stream.type);
    EXPECT_EQ(read.guard.message.stream.qos, written.guard.message.stream.qos);
    EXPECT_EQ(read.guard.message.stream.role, written.guard.message.stream.role);
    EXPECT_EQ(read.guard.message.stream.stamp, StampSource::Station);
    EXPECT_EQ(read.guard.message.frame, "base_link");
    for (std::size_t i = 0; i < wordsOf(written).size(); i += 2)
        EXPECT_THAT(guardHelp(), testing::HasSubstr("  " + wordsOf(written)[i] + " "));
}

TEST(GuardArguments, NonsenseIsRefusedByItsName) {
    const std::vector<std::string> good = wordsOf(someArguments());
    const auto with = [&](const std::string& name, const std::string& value) {
        std::vector<std::string> words = good;
        words.insert(words.end(), {name, value});
        return guardArgumentsFrom(words);
    };
    for (const auto& [name, value] :
         std::vector<std::pair<std::string, std::string>>{{"--domain", "233"},
                                                          {"--domain", "-1"},
                                                          {"--domain", "4x"},
                                                          {"--domain", "99999999999999999999"},
                                                          {"--driver", "0102"},
                                                          {"--driver", std::string(24, 'g')},
                                                          {"--driver", "+1020304050607080900aabb"},
                                                          {"--role", "points"},
                                                          {"--reliability", "perhaps"},
                                                          {"--lifespan", "nan"},
                                                          {"--lifespan", "inf"},
                                                          {"--lifespan", "-0.1"},
                                                          {"--lifespan", "0.2s"},
                                                          {"--stamp", "mine"},
                                                          {"--robot", ""},
                                                          {"--topic", ""},
                                                          {"--interface", ""},
                                                          {"--keys", ""},
                                                          {"--lifespan", std::string(100'000, '9')}}) {
        const auto read = with(name, value);
        ASSERT_FALSE(read.ok()) << name << ' ' << value.substr(0, 40);
        EXPECT_TRUE(read.error().text.starts_with(name + ": expected ")) << read.error().text;
    }
    EXPECT_FALSE(with("--speed", "1").ok());
    EXPECT_FALSE(guardArgumentsFrom({}).ok());
    EXPECT_FALSE(guardArgumentsFrom({"--domain"}).ok());
    EXPECT_FALSE(guardArgumentsFrom({"--robot", "kurt3d", "--station"}).ok());
}

/// A guard in this process, its pipe, and the wire to a robot that obeys whoever sends a command.
class DriveGuardTest : public testing::Test {
protected:
    DriveGuardTest() {
        EXPECT_EQ(socketpair(AF_UNIX, SOCK_SEQPACKET, 0, m_ends.data()), 0);
        const StreamDescription stream = *m_robot.stream(StreamRole::DriveCommand);
        m_wire = must(m_robotNode->subscribe(
            {stream.topic, stream.type, stream.qos}, [this, stream](const ReceivedSample& sample) {
                if (senderOf(sample.writer) != senderOf(m_guardNode->guid())) return;
                const auto twist = must(decode(sample.event, stream)).get<TwistSample>();
                m_zeros += twist.linear.isZero() && twist.angular.isZero() ? 1 : 0;
                m_others += twist.linear.isZero() ? 0 : 1;
            }));
        DriveGuardSettings settings;
        settings.robot = m_robot.name;
        settings.station = "a";
        settings.driver = senderOf(m_station->guid());
        settings.message = must(driveMessageFor(m_robot));
        m_guard = must(DriveGuard::create(*m_guardNode, settings));
        m_serving = std::jthread([this] {
            m_guard->serve(m_ends[1]);
            m_ended = true;
        });
    }
    ~DriveGuardTest() override {
        hangUp();
        m_serving.join();
        close(m_ends[1]);
    }
    void send(const std::string& text) const {
        EXPECT_GT(::send(m_ends[0], text.data(), text.size(), MSG_NOSIGNAL), 0);
    }
    void hangUp() {
        if (m_ends[0] >= 0) close(std::exchange(m_ends[0], -1));
    }
    /// The newest word that it has said.
    [[nodiscard]] std::string word() {
        std::array<char, 64> text{};
        for (ssize_t size = 0; (size = recv(m_ends[0], text.data(), text.size(), MSG_DONTWAIT)) > 0;)
            m_word.assign(text.data(), static_cast<std::size_t>(size));
        return m_word;
    }
    [[nodiscard]] bool isReady() {
        return waitUntil([&] { return word() == "ready"; });
    }

    const TestDomain m_domain;
    const RobotDescription m_robot = drivenRobot();
    NodeSettings named(const std::string& name) const { return {.domain = m_domain.number(), .name = name}; }
    const std::unique_ptr<Node> m_robotNode = must(Node::create(named("kurt3d"))),
                                m_guardNode = must(Node::create(named("leitstand-guard"))),
                                m_station = must(Node::create(named("leitstand")));
    std::array<int, 2> m_ends{};
    std::atomic<int> m_zeros = 0, m_others = 0;
    std::atomic<bool> m_ended = false;
    std::string m_word;
    std::unique_ptr<Subscription> m_wire;
    std::unique_ptr<DriveGuard> m_guard;
    std::jthread m_serving;
};

TEST_F(DriveGuardTest, IsReadyOnceTheRobotHearsItAndSendsZerosForTwoSecondsAfterASilence) {
    ASSERT_TRUE(isReady());
    const auto begin = std::chrono::steady_clock::now();
    while (std::chrono::steady_clock::now() - begin < 1s) {
        send("drive 0");
        std::this_thread::sleep_for(50ms);
    }
    EXPECT_EQ(m_zeros, 0);
    ASSERT_TRUE(waitUntil([&] { return m_zeros >= 30; }));
    std::this_thread::sleep_for(1500ms);
    EXPECT_LE(m_zeros, 41);
    EXPECT_EQ(m_others, 0);
    EXPECT_FALSE(m_ended);
}

TEST_F(DriveGuardTest, StationsThatListenAreNoRobot) {
    ASSERT_TRUE(isReady());
    const StreamDescription stream = *m_robot.stream(StreamRole::DriveCommand);
    const auto station = must(m_station->subscribe({stream.topic, stream.type, stream.qos}, [](auto) {}));
    ASSERT_TRUE(waitUntil([&] { return station->counts().writers == 1; }));
    m_wire.reset();
    EXPECT_TRUE(waitUntil([&] { return word() == "waits"; })) << "the robot is gone";
}

TEST_F(DriveGuardTest, AClosedPipeEndsIt) {
    ASSERT_TRUE(isReady());
    hangUp();
    EXPECT_TRUE(waitUntil([&] { return m_ended.load(); }, 5s));
    EXPECT_EQ(m_zeros, 0) << "nobody drove";
}

TEST_F(DriveGuardTest, WhatIsNoPulseIsSilence) {
    ASSERT_TRUE(isReady());
    send("drive 0");
    const auto begin = std::chrono::steady_clock::now();
    while (m_zeros == 0 && std::chrono::steady_clock::now() - begin < 5s) {
        send(std::string(40, '\xff'));
        send("drive ");
        std::this_thread::sleep_for(20ms);
    }
    EXPECT_GT(m_zeros, 0);
}

TEST_F(DriveGuardTest, ItsStationIsKnownByItsGrantsWhenItJoinedTheDomainAnew) {
    ASSERT_TRUE(isReady());
    const auto again = must(Node::create(named("leitstand")));
    const StreamDescription stream = *m_robot.stream(StreamRole::DriveCommand);
    const auto driver = must(again->publisher({stream.topic, stream.type, stream.qos, Flow::Immediate}));
    const auto keeper = must(GrantKeeper::create(*again, {"a", "Left desk", {{driveGrant("kurt3d"), 5}}}));
    const Payload command = must(must(driveMessageFor(m_robot)).encoded({0.2, 0.0, 0.0}, {}));
    EXPECT_TRUE(waitUntil([&] {
        send("drive 0");
        for (int i = 0; i < 12 && m_zeros == 0; ++i) {
            EXPECT_TRUE(driver->write(command));
            std::this_thread::sleep_for(50ms);
        }
        return m_zeros > 0;
    })) << "its own commands silence it";
}

TEST_F(DriveGuardTest, ItIsSilentBesideSomebodyElsesCommands) {
    ASSERT_TRUE(isReady());
    const StreamDescription stream = *m_robot.stream(StreamRole::DriveCommand);
    const auto other = must(Node::create(named("navigation")));
    const auto driver = must(other->publisher({stream.topic, stream.type, stream.qos, Flow::Immediate}));
    ASSERT_TRUE(waitUntil([&] { return driver->matched() >= 2; })) << "robot and guard";
    const Payload command = must(must(driveMessageFor(m_robot)).encoded({0.2, 0.0, 0.0}, {}));
    ASSERT_TRUE(driver->write(command));
    ASSERT_TRUE(driver->waitForAcknowledgments(5s));
    send("drive 0");
    const auto begin = std::chrono::steady_clock::now();
    while (std::chrono::steady_clock::now() - begin < 3s) {
        ASSERT_TRUE(driver->write(command));
        std::this_thread::sleep_for(50ms);
    }
    EXPECT_EQ(m_zeros, 0);
}

}  // namespace
}  // namespace leitstand::test
