// A robot that goes on without commands, driven by a station that hangs or dies: real processes, by the
// truth.
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/event/motion_samples.h"
#include "core/event/stream_role.h"
#include "core/io/robot/brake_file.h"
#include "tests/app/robots/station_and_robot.h"
#include "transport/convert/encode.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;
namespace fs = std::filesystem;

/// What /proc says of a process in line @p name of its status.
std::string statusOf(pid_t id, const std::string& name) {
    std::ifstream status("/proc/" + std::to_string(id) + "/status");
    for (std::string line; std::getline(status, line);) {
        if (line.starts_with(name + ":\t")) return line.substr(name.size() + 2);
    }
    return {};
}

bool lives(pid_t id) {
    const std::string state = statusOf(id, "State");
    return !state.empty() && state.front() != 'Z';
}

/// The guard that @p station has started.
std::optional<pid_t> guardOf(pid_t station) {
    for (const auto& entry : fs::directory_iterator("/proc")) {
        const std::string name = entry.path().filename();
        if (!std::all_of(name.begin(), name.end(), [](char one) { return one >= '0' && one <= '9'; }))
            continue;
        const pid_t id = std::stoi(name);
        if (statusOf(id, "PPid") == std::to_string(station) &&
            statusOf(id, "Name").starts_with("leitstand-guard") && lives(id))
            return id;
    }
    return std::nullopt;
}

class GuardedRobot : public StationAndRobot {
protected:
    GuardedRobot() {
        // It showed in an earlier brake test that it goes on.
        const BrakeResult none{.verdict = BrakeResult::Verdict::Failed,
                               .seconds = 1.6,
                               .metres = 0.3,
                               .watchdog = BrakeResult::Watchdog::None};
        EXPECT_TRUE(writeBrakes(m_folder / "brakes.yaml", {{"kurt3d", none}}).ok());
        startRobot({"--no-watchdog"});
        startStation({"--blind", "--nevertheless"});
    }
};

using GuardedRobotLatency = GuardedRobot;

TEST_F(GuardedRobotLatency, StandsWhenItsStationIsKilledAndNothingIsLeftBehind) {
    ASSERT_TRUE(drives()) << words();
    const auto guard = guardOf(m_station->id());
    ASSERT_TRUE(guard);
    const double megabytes = std::stod(statusOf(*guard, "VmRSS")) * 1024.0 / 1e6;
    const double took = standsAfter(SIGKILL);
    std::printf("guard of %.1f MB: the robot stands %.0f ms after its station was killed\n", megabytes,
                1e3 * took);
    EXPECT_LE(megabytes, 30.0);
    EXPECT_LE(took, 0.5);
    m_station->wait();
    EXPECT_TRUE(waitUntil([&] { return !lives(*guard); }, 10s)) << "two seconds of zeros, and it ends";
    EXPECT_LT(m_truth.now(), TrueSpeed::Standing);
}

TEST_F(GuardedRobotLatency, StandsWhenItsStationIsFrozenAndObeysItAgainAfterwards) {
    ASSERT_TRUE(drives()) << words();
    const auto guard = guardOf(m_station->id());
    ASSERT_TRUE(guard);
    const double took = standsAfter(SIGSTOP);
    std::printf("the robot stands %.0f ms after its station was frozen\n", 1e3 * took);
    EXPECT_LE(took, 0.5);
    std::this_thread::sleep_for(3s);  // longer than its zeros
    EXPECT_TRUE(lives(*guard)) << "the station may be back";
    const Time back = TrueSpeed::Clock::now();
    m_station->signal(SIGCONT);
    std::this_thread::sleep_for(1s);
    EXPECT_LT(m_truth.fastestSince(back), TrueSpeed::Standing) << "the stick is held";
    m_station->turn();
    EXPECT_TRUE(drives()) << m_station->out();
    EXPECT_LE(standsAfter(SIGSTOP), 0.5) << "guarded again";
}

TEST_F(GuardedRobot, AnotherDriverIsNotDisturbed) {
    ASSERT_TRUE(drives()) << words();
    const auto node = nodeIn(m_domain, {.interfaces = {"lo"}});
    const RobotDescription description = shippedRobot("kurt3d");
    const StreamDescription& stream = *description.stream(StreamRole::DriveCommand);
    const auto publisher = must(node->publisher({stream.topic, stream.type, stream.qos, Flow::Immediate}));
    ASSERT_TRUE(waitUntil([&] { return publisher->matched() >= 3; })) << "robot, station and guard";
    TwistSample twist;
    twist.linear.x() = -0.1;
    const Payload command = must(encode(twist, stream.type));
    const std::jthread driver([&](const std::stop_token& stop) {
        while (!stop.stop_requested()) {
            static_cast<void>(publisher->write(command));
            std::this_thread::sleep_for(50ms);
        }
    });
    std::this_thread::sleep_for(200ms);
    m_station->signal(SIGSTOP);
    std::this_thread::sleep_for(700ms);  // the other one's speed is reached, and the guard is alarmed
    for (const auto end = std::chrono::steady_clock::now() + 2s; std::chrono::steady_clock::now() < end;) {
        ASSERT_NEAR(m_truth.now(), 0.1, 0.03) << "somebody else's zeros";
        std::this_thread::sleep_for(5ms);
    }
}

TEST_F(GuardedRobot, IsNotDrivenWithoutItsGuard) {
    ASSERT_TRUE(drives()) << words();
    const auto guard = guardOf(m_station->id());
    ASSERT_TRUE(guard);
    const Time gone = TrueSpeed::Clock::now();
    ASSERT_EQ(kill(*guard, SIGKILL), 0);
    EXPECT_TRUE(waitUntil([&] { return m_truth.stoodAfter(gone).has_value(); }, 10s));
    EXPECT_LE(m_truth.stoodAfter(gone).value_or(99.0), 1.0);
    ASSERT_TRUE(waitUntil([&] { return guardOf(m_station->id()).has_value(); }, 20s))
        << "it is started again";
    m_station->turn();
    EXPECT_TRUE(drives()) << m_station->out();
    EXPECT_FALSE(lives(*guard)) << "nor is it left as a zombie";
}

TEST_F(GuardedRobot, WhereNoGuardCanBeStartedItIsNotDriven) {
    m_station.reset();
    // The guard is looked for beside the station's own program.
    const fs::path alone = m_folder / "held_station";
    fs::copy_file(program("held_station"), alone);
    const Time begun = TrueSpeed::Clock::now();
    const ChildProcess station(alone, {m_folder.path().string(), std::to_string(m_domain.number()), "kurt3d",
                                       std::to_string(Speed), "--blind", "--nevertheless"});
    ASSERT_TRUE(waitUntil([&] { return station.out().find("guard failed") != std::string::npos; }, 60s))
        << station.out();
    std::this_thread::sleep_for(3s);  // it would have driven by now
    EXPECT_LT(m_truth.fastestSince(begun), TrueSpeed::Standing);
    EXPECT_THAT(station.out(), testing::Not(testing::HasSubstr("drives")));
}

}  // namespace
}  // namespace leitstand::test
