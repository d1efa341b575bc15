#include <atomic>
#include <csignal>
#include <cstdio>
#include <memory>
#include <optional>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "core/event/command_samples.h"
#include "core/event/station_topics.h"
#include "core/event/stream_role.h"
#include "core/robot/streams/stream_defaults.h"
#include "tests/support/child_process.h"
#include "tests/support/net/radio_link.h"
#include "tests/support/places.h"
#include "tests/support/temporary_folder.h"
#include "tests/transport/link/control_robot.h"
#include "tests/transport/link/control_station.h"
#include "transport/convert/decode.h"
#include "transport/convert/encode.h"
#include "transport/security/enclave.h"
#include "transport/security/keys.h"
#include "transport/services/service_server.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;
using Milliseconds = std::chrono::duration<double, std::milli>;

const StationIdentity Holder{"a", "Left desk", {{driveGrant("kurt3d"), 5}}};

/// Writes stop commands as they are, of whomever.
class RawStops {
public:
    explicit RawStops(Node& node, const StreamDescription& stream)
        : m_stream(stream),
          m_publisher(must(node.publisher({stream.topic, stream.type, stream.qos, Flow::Immediate}))) {}
    void publish(const StopCommandSample& command) {
        ASSERT_TRUE(m_publisher->write(must(encode(command, m_stream.type))).ok());
    }
    [[nodiscard]] bool matched() const { return m_publisher->matched() > 0; }

private:
    StreamDescription m_stream;
    std::unique_ptr<Publisher> m_publisher;
};

class Stop : public testing::Test {
protected:
    const TestDomain m_domain;
    const RobotDescription m_description = drivenRobot();
    const StreamDescription m_stopStream = *m_description.stream(StreamRole::StopCommand);
};

/// With the robot in the test's own process.
class StopHere : public Stop {
protected:
    [[nodiscard]] bool drives(double speed = 0.3) {
        return m_station.driveUntil(speed, [&] { return m_robot.speed() == speed; });
    }
    std::unique_ptr<Node> m_robotNode = nodeIn(m_domain), m_node = nodeIn(m_domain);
    ControlRobot m_robot{*m_robotNode, m_description};
    ControlStation m_station{*m_node, m_description, Holder};
};

TEST_F(StopHere, IsSentAcknowledgedAndStandingAndReleasedWithNeutralSticks) {
    ASSERT_TRUE(drives());
    const auto pressed = Clock::now();
    m_station.stops().stopAll();
    ASSERT_TRUE(waitUntil([&] { return m_robot.speed() == 0.0; }));
    const double stopped = Milliseconds(Clock::now() - pressed).count();
    EXPECT_TRUE(m_station.stopStatus().sent);
    ASSERT_TRUE(waitUntil([&] { return m_station.stopStatus().acknowledged; }));
    const double acknowledged = Milliseconds(Clock::now() - pressed).count();
    ASSERT_TRUE(waitUntil([&] { return m_station.stopStatus().standing; }));
    const double standing = Milliseconds(Clock::now() - pressed).count();
    std::printf(
        "stop: the robot stopped after %.1f ms, acknowledged after %.1f ms, told to stand after %.1f ms\n",
        stopped, acknowledged, standing);
    EXPECT_LT(acknowledged, 1'000.0);
    EXPECT_TRUE(m_robot.commands().isStopped());
    EXPECT_TRUE(m_station.stopStatus().stopped);
    ASSERT_TRUE(m_station.stops().release("kurt3d").ok());
    ASSERT_TRUE(waitUntil([&] { return !m_robot.commands().isStopped() && !m_station.stopStatus().sent; }));
    // The stick is still pushed.
    EXPECT_FALSE(waitUntil([&] { return m_robot.speed() != 0.0; }, 500ms))
        << "motion never resumes by itself";
    EXPECT_TRUE(drives(0.2));
}

TEST_F(StopHere, AnybodyMayStopOnlyTheHolderReleases) {
    ASSERT_TRUE(drives());
    const auto otherNode = nodeIn(m_domain);
    const auto other =
        must(StopSender::create(*otherNode, std::vector{m_description}, {.station = "viewer"}));
    ASSERT_TRUE(waitUntil(
        [&] { return !other->status("kurt3d").stoppedBy.empty() || other->allowsDriving("kurt3d"); }));
    other->stop("kurt3d");
    ASSERT_TRUE(waitUntil([&] { return other->status("kurt3d").acknowledged; }));
    EXPECT_EQ(m_robot.speed(), 0.0);
    EXPECT_FALSE(other->release("kurt3d").ok());
    EXPECT_FALSE(other->release("nobody").ok());
    ASSERT_TRUE(waitUntil([&] { return m_station.stopStatus().stoppedBy == "viewer"; }));
    EXPECT_FALSE(m_station.stops().allowsDriving("kurt3d"));
    // One that does not ask its own side first, and says that it is the holder.
    RawStops forged(*otherNode, m_stopStream);
    ASSERT_TRUE(waitUntil([&] { return forged.matched(); }));
    forged.publish({{}, "a", ~std::uint64_t{0}, false, 0});
    ASSERT_TRUE(waitUntil([&] { return m_robot.commands().counts().stops >= 2; }));
    EXPECT_TRUE(m_robot.commands().isStopped());
    ASSERT_TRUE(m_station.stops().release("kurt3d").ok());
    ASSERT_TRUE(waitUntil([&] { return !m_robot.commands().isStopped(); }));
    ASSERT_TRUE(waitUntil([&] { return !other->status("kurt3d").sent; })) << "it hears that it is over";
}

TEST_F(StopHere, AStationThatStartedAnewWithSmallerNumbersStops) {
    ASSERT_TRUE(drives());
    m_station.stops().stopAll();
    ASSERT_TRUE(waitUntil([&] { return m_station.stopStatus().acknowledged; }));
    ASSERT_TRUE(m_station.stops().release("kurt3d").ok());
    ASSERT_TRUE(waitUntil([&] { return !m_robot.commands().isStopped(); }));
    const auto again = nodeIn(m_domain);
    RawStops restarted(*again, m_stopStream);
    ASSERT_TRUE(waitUntil([&] { return restarted.matched(); }));
    restarted.publish({{}, "a", 1, true, 0});
    EXPECT_TRUE(waitUntil([&] { return m_robot.commands().isStopped(); }));
}

TEST_F(StopHere, AReplayedReleaseReleasesNothing) {
    RawStops raw(*m_node, m_stopStream);  // from the holder's own process
    ASSERT_TRUE(waitUntil([&] { return raw.matched() && m_robot.commands().holder() == "a"; }));
    m_station.stops().stop("kurt3d");
    ASSERT_TRUE(waitUntil([&] { return m_station.stopStatus().acknowledged; }));
    ASSERT_TRUE(m_station.stops().release("kurt3d").ok());
    ASSERT_TRUE(waitUntil([&] { return !m_robot.commands().isStopped(); }));
    m_station.stops().stop("kurt3d");
    ASSERT_TRUE(waitUntil([&] { return m_station.stopStatus().acknowledged; }));
    const auto before = m_robot.commands().counts().stops;
    for (std::uint64_t number = 1; number <= 100; ++number) raw.publish({{}, "a", number, false, number});
    ASSERT_TRUE(waitUntil([&] { return m_robot.commands().counts().stops > before; }));
    EXPECT_TRUE(m_robot.commands().isStopped());
}

TEST_F(StopHere, TheButtonOfTheRobotStopsTooAndTheHolderReleases) {
    ASSERT_TRUE(drives());
    m_robot.commands().press();
    EXPECT_EQ(m_robot.speed(), 0.0);
    ASSERT_TRUE(waitUntil([&] { return m_station.stopStatus().stopped; }));
    EXPECT_EQ(m_station.stopStatus().stoppedBy, "");
    ASSERT_TRUE(m_station.stops().release("kurt3d").ok());
    EXPECT_TRUE(drives());
}

TEST_F(StopHere, AStopGivenBeforeTheRobotIsThereStopsIt) {
    RobotDescription later = drivenRobot("crawler");
    const auto stops = must(StopSender::create(*m_node, std::vector{later}, {.station = "a"}));
    stops->stopAll();
    EXPECT_TRUE(stops->status("crawler").sent);
    EXPECT_FALSE(stops->status("crawler").acknowledged);
    ControlRobot crawler(*m_robotNode, later);
    EXPECT_TRUE(
        waitUntil([&] { return crawler.commands().isStopped() && stops->status("crawler").acknowledged; }));
}

TEST_F(StopHere, RobotsWithoutAStopCommandAreHeldByZeros) {
    RobotDescription plain = drivenRobot("turtle");
    std::erase_if(plain.streams, [](const auto& stream) { return stream.role == StreamRole::StopCommand; });
    ControlStation station(*m_node, plain, {"a", "", {{driveGrant("turtle"), 5}}});
    std::atomic<int> zeros = 0, others = 0;
    const StreamDescription stream = *plain.stream(StreamRole::DriveCommand);
    const auto listening =
        must(m_robotNode->subscribe({stream.topic, stream.type, stream.qos}, [&](auto sample) {
            ++(std::all_of(sample.event.cdr->begin() + 4, sample.event.cdr->end(),
                           [](std::byte byte) { return byte == std::byte{0}; })
                   ? zeros
                   : others);
        }));
    ASSERT_TRUE(station.driveUntil(0.3, [&] { return others > 0; }));
    station.stops().stopAll();
    EXPECT_FALSE(station.stopStatus().supported);
    ASSERT_TRUE(waitUntil([&] { return station.streamer().status().velocity == DriveVelocity{}; }));
    zeros = 0;
    ASSERT_TRUE(waitUntil([&] { return zeros > 50; })) << "longer than after driving";
    ASSERT_TRUE(station.stops().release("turtle").ok());
    EXPECT_TRUE(station.driveUntil(0.2, [&] { return station.streamer().status().velocity.forward > 0.0; }));
}

/// The robot is a process whose clock is wrong.
class StopWithWrongClock : public Stop, public testing::WithParamInterface<int> {};

TEST_P(StopWithWrongClock, DrivesStopsAndReleasesAllTheSame) {
#if defined(__SANITIZE_THREAD__) || defined(__SANITIZE_ADDRESS__)
    GTEST_SKIP() << "SKIPPED: sanitizers bring clocks of their own, which cannot be shifted";
#endif
    const ChildProcess robot(program("control_peer"), {"robot", std::to_string(m_domain.number())},
                             {"CLOCK_AHEAD=" + std::to_string(GetParam())});
    const auto decoded = [&](const std::string& word) { return robot.out().find(word) != std::string::npos; };
    const auto node = nodeIn(m_domain);
    std::atomic<std::int64_t> stamped = 0;
    const StreamDescription& odometry = *m_description.stream(StreamRole::Odometry);
    const auto listening =
        must(node->subscribe({odometry.topic, odometry.type, odometry.qos}, [&](auto sample) {
            stamped =
                std::chrono::round<std::chrono::seconds>(sample.sourceTime - sample.event.received).count();
        }));
    ControlStation station(*node, m_description, Holder);
    ASSERT_TRUE(station.driveUntil(0.3, [&] { return decoded("moves"); })) << robot.out();
    EXPECT_TRUE(waitUntil([&] { return stamped == GetParam(); }))
        << stamped << ": the test means nothing with a right clock";
    const auto pressed = Clock::now();
    station.stops().stopAll();
    ASSERT_TRUE(waitUntil([&] { return station.stopStatus().acknowledged; }));
    std::printf("clock %+d s off: stop acknowledged after %.1f ms\n", GetParam(),
                Milliseconds(Clock::now() - pressed).count());
    ASSERT_TRUE(
        waitUntil([&] { return decoded("stopped") && decoded("rests") && station.stopStatus().standing; }));
    ASSERT_TRUE(station.stops().release("kurt3d").ok());
    ASSERT_TRUE(waitUntil([&] { return decoded("free"); })) << robot.out();
    station.push(0.0);
    ASSERT_TRUE(
        station.driveUntil(0.2, [&] { return robot.out().rfind("moves") > robot.out().rfind("free"); }));
}
INSTANTIATE_TEST_SUITE_P(Clocks, StopWithWrongClock, testing::Values(5, -5));

/// 10 Mbit/s, 20 ms, 5 % loss between the station and a robot in another process.
class StopOverRadio : public Stop {
protected:
    void SetUp() override {
        if (const std::string why = whyNoNamespaces(); !why.empty()) {
            GTEST_SKIP() << "SKIPPED: the radio link needs network namespaces and TUN: " << why;
        }
        m_radio.emplace();
        {
            const InNamespace there(m_radio->robots());
            m_robot = std::make_unique<ChildProcess>(
                program("control_peer"), std::vector<std::string>{"robot", std::to_string(m_domain.number())},
                std::vector<std::string>{"CLOCK_AHEAD=5"});
        }
        m_here.emplace(m_radio->station());
        m_node = nodeIn(m_domain);
        m_station = std::make_unique<ControlStation>(*m_node, m_description, Holder);
    }
    [[nodiscard]] bool decoded(const std::string& word) const {
        return m_robot->out().find(word) != std::string::npos;
    }
    std::optional<RadioLink> m_radio;
    std::optional<InNamespace> m_here;
    std::unique_ptr<ChildProcess> m_robot;
    std::unique_ptr<Node> m_node;
    std::unique_ptr<ControlStation> m_station;
};

TEST_F(StopOverRadio, SurvivesTwoSecondsOfTotalLoss) {
    ASSERT_TRUE(m_station->driveUntil(0.3, [&] { return decoded("moves"); })) << m_robot->out();
    m_radio->setOutage(true);
    const auto lost = Clock::now();
    m_station->stops().stopAll();
    ASSERT_TRUE(waitUntil([&] { return decoded("rests"); }));
    const double stood = Milliseconds(Clock::now() - lost).count();
    EXPECT_FALSE(waitUntil([&] { return Clock::now() - lost >= 2s && decoded("stopped"); }, 2s));
    EXPECT_FALSE(decoded("stopped")) << "nothing gets through";
    EXPECT_FALSE(m_station->stopStatus().acknowledged);
    EXPECT_GE(m_station->stopStatus().unanswered, 1s);
    m_radio->setOutage(false);
    const auto back = Clock::now();
    ASSERT_TRUE(waitUntil([&] { return decoded("stopped"); }));
    const double stopped = Milliseconds(Clock::now() - back).count();
    ASSERT_TRUE(waitUntil([&] { return m_station->stopStatus().acknowledged; }));
    const double acknowledged = Milliseconds(Clock::now() - back).count();
    std::printf(
        "2 s of total loss: the robot stood %.0f ms after it began; stopped %.0f ms and acknowledged %.0f ms "
        "after it was over\n",
        stood, stopped, acknowledged);
    EXPECT_LT(stood, 700.0);
    EXPECT_LT(acknowledged, 2'000.0);
    ASSERT_TRUE(waitUntil([&] { return m_station->stopStatus().standing; }));
    // Its stick has been pushed all the time.
    EXPECT_TRUE(m_robot->out().rfind("moves") < m_robot->out().rfind("rests"));
    ASSERT_TRUE(m_station->stops().release("kurt3d").ok());
    ASSERT_TRUE(waitUntil([&] { return decoded("free"); }));
    m_station->push(0.0);
    EXPECT_TRUE(m_station->driveUntil(
        0.2, [&] { return m_robot->out().rfind("moves") > m_robot->out().rfind("free"); }));
}

TEST_F(StopOverRadio, AReleaseThatDoesNotGetThroughIsTakenBack) {
    ASSERT_TRUE(m_station->driveUntil(0.3, [&] { return decoded("moves"); })) << m_robot->out();
    m_station->stops().stopAll();
    ASSERT_TRUE(waitUntil([&] { return m_station->stopStatus().acknowledged; }));
    m_radio->setOutage(true);
    ASSERT_TRUE(m_station->stops().release("kurt3d").ok());
    ASSERT_TRUE(waitUntil([&] { return !m_station->stopStatus().releasing; }));
    EXPECT_TRUE(m_station->stopStatus().sent);
    EXPECT_FALSE(m_station->stopStatus().refused.empty());
    m_radio->setOutage(false);
    ASSERT_TRUE(waitUntil([&] { return m_station->stopStatus().acknowledged; }));
    EXPECT_FALSE(decoded("free"));
}

/// A domain with keys for a station, a robot and a viewer.
class StopSecured : public Stop {
protected:
    StopSecured() {
        const auto made = createKeys(m_folder / "keys", {{KeyRole::Station, "station1", {}, false},
                                                         {KeyRole::Robot, "kurt3d", {}, false},
                                                         {KeyRole::Viewer, "coach", {}, false}});
        EXPECT_TRUE(made.ok()) << made.error().text;
    }
    [[nodiscard]] std::unique_ptr<Node> nodeOf(const std::string& name) const {
        NodeSettings settings;
        settings.security = must(securityFiles(m_folder / "keys/enclaves" / name));
        return nodeIn(m_domain, settings);
    }
    const TemporaryFolder m_folder;
};

TEST_F(StopSecured, AViewerMayStopButNotDrive) {
    const auto robotNode = nodeOf("kurt3d"), stationNode = nodeOf("station1"), viewerNode = nodeOf("coach");
    ControlRobot robot(*robotNode, m_description);
    ControlStation station(*stationNode, m_description, Holder);
    ASSERT_TRUE(station.driveUntil(0.3, [&] { return robot.speed() > 0.0; }));
    EXPECT_FALSE(GrantKeeper::create(*viewerNode, {"v", "", {}}).ok());
    EXPECT_FALSE(DriveStreamer::create(*viewerNode, m_description, {}).ok());
    const auto viewer = must(StopSender::create(*viewerNode, std::vector{m_description}, {.station = "v"}));
    viewer->stopAll();
    ASSERT_TRUE(waitUntil([&] { return viewer->status("kurt3d").acknowledged; }));
    EXPECT_EQ(robot.speed(), 0.0);
    EXPECT_FALSE(viewer->release("kurt3d").ok());
    ASSERT_TRUE(waitUntil([&] { return station.stopStatus().stoppedBy == "v"; }));
    ASSERT_TRUE(station.stops().release("kurt3d").ok());
    station.push(0.0);
    EXPECT_TRUE(station.driveUntil(0.2, [&] { return robot.speed() > 0.0; }));
}

TEST_F(StopSecured, AStationCallsServicesAndAViewerIsToldThatItMayNot) {
    const auto robotNode = nodeOf("kurt3d"), stationNode = nodeOf("station1"), viewerNode = nodeOf("coach");
    RobotDescription robot = m_description;
    robot.services = {
        {.name = "/kurt3d/e_stop", .type = "std_srvs/srv/SetBool", .title = "E-stop", .stop = true}};
    std::atomic<bool> on = false;
    const auto server = must(ServiceServer::create(*robotNode, "/kurt3d/e_stop", "std_srvs/srv/SetBool",
                                                   [&](const ServiceRequest& request) {
                                                       on = request.value;
                                                       return ServiceAnswer{true, ""};
                                                   }));
    const auto viewer = must(StopSender::create(*viewerNode, std::vector{robot}, {.station = "v"}));
    viewer->stopAll();
    EXPECT_NE(viewer->status("kurt3d").services.front().message, "");
    std::this_thread::sleep_for(500ms);
    EXPECT_FALSE(on);
    const auto station = must(StopSender::create(*stationNode, std::vector{robot}, {.station = "a"}));
    station->stopAll();
    EXPECT_TRUE(waitUntil([&] { return on.load(); }));
    EXPECT_EQ(station->status("kurt3d").services.front().message, "");
}

/// A stock robot: it knows no stops, and has a lock as twist_mux has it.
class StopByLock : public testing::Test {
protected:
    static RobotDescription stockRobot() {
        RobotDescription robot = drivenRobot();
        std::erase_if(robot.streams, [](const StreamDescription& stream) {
            return stream.role == StreamRole::StopCommand || stream.role == StreamRole::StopState;
        });
        robot.streams.push_back(defaultStream(StreamRole::StopLock, robot.name, {}));
        return robot;
    }
    /// Number of messages so far that set the lock, or that freed it.
    [[nodiscard]] int count(bool locked) const { return locked ? m_set : m_freed; }

    const TestDomain m_domain;
    const RobotDescription m_description = stockRobot();
    const StreamDescription m_lock = *m_description.stream(StreamRole::StopLock);
    std::atomic<int> m_set = 0, m_freed = 0;
    std::unique_ptr<Node> m_robotNode = nodeIn(m_domain), m_node = nodeIn(m_domain);
    std::unique_ptr<StopSender> m_stops =
        must(StopSender::create(*m_node, std::vector{m_description},
                                {.station = "a", .mayRelease = [](const std::string&) { return true; }}));
    std::unique_ptr<Subscription> m_mux;
    void listen() {
        m_mux = must(m_robotNode->subscribe({m_lock.topic, m_lock.type, m_lock.qos, Lane::Small},
                                            [this](const ReceivedSample& sample) {
                                                const auto lock = decode(sample.event, m_lock);
                                                if (!lock) return;
                                                ++(lock->get<DriveLockSample>().locked ? m_set : m_freed);
                                            }));
        ASSERT_TRUE(waitUntil([&] { return m_stops->status("kurt3d").lockHeard; }));
    }
};

TEST_F(StopByLock, IsSetAgainAndAgainUntilTheReleaseFreesIt) {
    EXPECT_TRUE(m_stops->status("kurt3d").locks);
    EXPECT_FALSE(m_stops->status("kurt3d").lockHeard) << "nobody listens yet";
    ASSERT_NO_FATAL_FAILURE(listen());
    std::this_thread::sleep_for(300ms);
    EXPECT_EQ(count(true) + count(false), 0) << "nobody stopped it: the lock is somebody else's";
    m_stops->stopAll();
    EXPECT_TRUE(m_stops->holdsByZeros("kurt3d")) << "besides";
    ASSERT_TRUE(waitUntil([&] { return count(true) >= 5; })) << "a multiplexer may forget it";
    EXPECT_EQ(count(false), 0);
    ASSERT_TRUE(m_stops->release("kurt3d").ok());
    ASSERT_TRUE(waitUntil([&] { return count(false) > 0; }));
    std::this_thread::sleep_for(1s);
    const int set = count(true), freed = count(false);
    EXPECT_GE(freed, 2) << "one may be lost";
    std::this_thread::sleep_for(500ms);
    EXPECT_EQ(count(false), freed) << "then it is somebody else's again";
    EXPECT_EQ(count(true), set);
    m_stops->stop("kurt3d");
    ASSERT_TRUE(waitUntil([&] { return count(true) > set; }));
}

TEST_F(StopByLock, AMultiplexerThatStartsLaterIsLockedAsWell) {
    m_stops->stopAll();
    std::this_thread::sleep_for(300ms);
    ASSERT_NO_FATAL_FAILURE(listen());
    EXPECT_TRUE(waitUntil([&] { return count(true) >= 2; }));
}

}  // namespace
}  // namespace leitstand::test
