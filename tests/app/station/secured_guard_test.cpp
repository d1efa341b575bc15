// The guard of a robot without a watchdog in a domain with keys: it takes part with those of its station.
#include <atomic>
#include <thread>

#include <gtest/gtest.h>

#include "app/services/station/safety/guard_process.h"
#include "app/services/station/safety/station_brakes.h"
#include "app/services/station/safety/station_guards.h"
#include "core/event/motion_samples.h"
#include "core/event/stream_role.h"
#include "core/io/robot/brake_file.h"
#include "tests/app/station/careless_robot.h"
#include "tests/app/station/station_scene.h"
#include "transport/convert/decode.h"
#include "transport/link/grant_sender.h"
#include "transport/link/guard_arguments.h"
#include "transport/security/enclave.h"
#include "transport/security/keys.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

class SecuredGuard : public StationScene {
protected:
    SecuredGuard() {
        const auto made = createKeys(
            m_folder / "keys", {{KeyRole::Station, "desk", {}, false}, {KeyRole::Robot, "rover", {}, false}});
        EXPECT_TRUE(made.ok()) << made.error().text;
    }
    [[nodiscard]] std::filesystem::path keysOf(const std::string& name) const {
        return m_folder / "keys" / "enclaves" / name;
    }
    [[nodiscard]] std::unique_ptr<Node> member(const std::string& name) const {
        NodeSettings settings;
        settings.name = name;
        settings.security = must(securityFiles(keysOf(name)));
        return nodeIn(m_domain, settings);
    }
    /// Of the robot, for a station whose node is @p station.
    [[nodiscard]] std::unique_ptr<GuardProcess> guardFor(const Node& station) const {
        GuardArguments arguments;
        arguments.network.domain = m_domain.number();
        arguments.keys = keysOf("desk");
        arguments.guard.robot = m_robot.name;
        arguments.guard.station = "desk";
        arguments.guard.driver = senderOf(station.guid());
        arguments.guard.message = must(driveMessageFor(m_robot));
        return must(GuardProcess::start(guardProgram(), wordsOf(arguments)));
    }

    const RobotDescription m_robot = carelessRobot();
};

/// Drive commands that a robot hears, those of its station and those of others.
class HeardCommands {
public:
    HeardCommands(Node& robot, const StreamDescription& stream, const Sender& station)
        : m_listening(must(robot.subscribe({stream.topic, stream.type, stream.qos, Lane::Small},
                                           [this, stream, station](const ReceivedSample& sample) {
                                               const auto twist =
                                                   must(decode(sample.event, stream)).get<TwistSample>();
                                               const bool zero =
                                                   twist.linear.isZero() && twist.angular.isZero();
                                               if (senderOf(sample.writer) == station) {
                                                   ++ofTheStation;
                                               } else {
                                                   ++(zero ? zeros : others);
                                               }
                                           }))) {}
    std::atomic<int> ofTheStation = 0, zeros = 0, others = 0;

private:
    std::unique_ptr<Subscription> m_listening;  ///< last: it calls back
};

TEST_F(SecuredGuard, IsReadyOnceTheRobotHearsItAndSendsZerosForTwoSecondsAfterASilence) {
    const StreamDescription stream = *m_robot.stream(StreamRole::DriveCommand);
    const auto desk = member("desk");
    const auto guard = guardFor(*desk);
    const auto isReady = [&] { return guard->read() && guard->isReady(Clock::now()); };
    ASSERT_TRUE(waitUntil([&] { return desk->participants().size() == 1; }, 60s));
    EXPECT_FALSE(waitUntil(isReady, 1s)) << "there is no robot";

    const auto rover = member("rover");
    HeardCommands received(*rover, stream, senderOf(desk->guid()));
    ASSERT_TRUE(waitUntil(isReady, 60s));
    const auto driver = must(desk->publisher({stream.topic, stream.type, stream.qos, Flow::Immediate}));
    ASSERT_TRUE(waitUntil([&] { return driver->matched() == 2; }, 60s)) << "robot and guard";
    const Payload command = must(must(driveMessageFor(m_robot)).encoded({0.2, 0.0, 0.0}, {}));
    for (const auto end = Clock::now() + 1s; Clock::now() < end; std::this_thread::sleep_for(50ms)) {
        ASSERT_TRUE(driver->write(command).ok());
        ASSERT_TRUE(guard->pulse({.driving = true}));
    }
    EXPECT_EQ(received.zeros, 0);
    EXPECT_GT(received.ofTheStation, 10);

    ASSERT_TRUE(waitUntil([&] { return received.zeros >= 1; }));
    const auto first = Clock::now();
    ASSERT_TRUE(waitUntil([&] { return received.zeros >= 30; })) << received.zeros;
    std::this_thread::sleep_until(first + 3s);
    const int zeros = received.zeros;
    EXPECT_LE(zeros, 41) << "20 a second, for two seconds";
    std::this_thread::sleep_for(1s);
    EXPECT_EQ(received.zeros, zeros) << "and no more";
    EXPECT_EQ(received.others, 0);
}

TEST_F(SecuredGuard, ARobotWithoutAWatchdogIsNotDrivenBeforeItHearsItsGuard) {
    // It showed in an earlier brake test that it goes on.
    const BrakeResult none{.verdict = BrakeResult::Verdict::Failed,
                           .seconds = 1.6,
                           .metres = 0.3,
                           .watchdog = BrakeResult::Watchdog::None};
    ASSERT_TRUE(writeBrakes(m_folder / "brakes.yaml", {{"rover", none}}).ok());
    const auto node = member("rover");
    CarelessRobot rover(*node, m_robot);
    StationSettings settings = settingsFor({m_robot});
    settings.domain.keys = keysOf("desk");
    const auto station = must(Station::open(settings));
    station->brakes().setOverridden("rover", true);
    EXPECT_FALSE(station->guards().allows("rover"));
    bool received = false, early = false;
    ASSERT_TRUE(drive(*station, "rover", {0.2, 0.0, 0.0}, [&] {
        const bool moves = rover.speed() != 0.0;
        received = received || station->guards().view("rover").state == GuardView::State::Ready;
        early = early || (moves && !received);
        return received && rover.speed() > 0.1;
    })) << station->guards().view("rover").problem;
    EXPECT_FALSE(early);
    station->setDriveFocus({});
    EXPECT_TRUE(waitUntil([&] { return rover.speed() == 0.0; }));
}

}  // namespace
}  // namespace leitstand::test
