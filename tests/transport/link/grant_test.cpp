#include <csignal>
#include <cstdio>

#include <gtest/gtest.h>

#include "tests/support/child_process.h"
#include "tests/support/places.h"
#include "tests/transport/link/control_robot.h"
#include "tests/transport/link/control_station.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;
using Seconds = std::chrono::duration<double>;

std::chrono::steady_clock::time_point now() {
    return std::chrono::steady_clock::now();
}

class Grants : public testing::Test {
protected:
    [[nodiscard]] std::unique_ptr<ChildProcess> stationProcess(const std::string& id, const std::string& term,
                                                               const std::string& speed = "0.3") const {
        return std::make_unique<ChildProcess>(
            program("control_peer"),
            std::vector<std::string>{"station", std::to_string(m_domain.number()), id, term, speed});
    }
    const TestDomain m_domain;
    const RobotDescription m_description = drivenRobot();
    std::unique_ptr<Node> m_robotNode = nodeIn(m_domain), m_node = nodeIn(m_domain);
    ControlRobot m_robot{*m_robotNode, m_description};
};

// The holder is a process that drives; it is killed, so that nothing is said for it.
TEST_F(Grants, ASecondStationIsRefusedUntilTheHolderIsSilentForThreeSeconds) {
    const auto holder = stationProcess("b", "5");
    ASSERT_TRUE(waitUntil([&] { return m_robot.speed() > 0.0; })) << holder->out();
    EXPECT_EQ(m_robot.commands().holder(), "b");
    ControlStation second(*m_node, m_description, {"a", "Left desk", {}});
    second.ask();
    ASSERT_TRUE(waitUntil([&] { return second.view().holder == "b"; }));
    // It tries to drive all the same, for longer than the time of silence.
    second.focus();
    second.push(-0.4);
    EXPECT_FALSE(waitUntil([&] { return second.mayDrive() || m_robot.speed() < 0.0; }, 4s));
    EXPECT_TRUE(waitUntil([&] { return m_robot.speed() > 0.0; })) << "the holder drives undisturbed";
    const auto killed = now();
    holder->signal(SIGKILL);
    ASSERT_TRUE(waitUntil([&] { return m_robot.speed() == 0.0; }));
    const Seconds stood = now() - killed;
    ASSERT_TRUE(waitUntil([&] { return second.mayDrive(); }));
    const Seconds taken = now() - killed;
    ASSERT_TRUE(second.driveUntil(-0.4, [&] { return m_robot.speed() < 0.0; }));
    const Seconds driven = now() - killed;
    std::printf(
        "holder killed: the robot stood after %.2f s, the second had the grant after %.2f s, drove after "
        "%.2f s\n",
        stood.count(), taken.count(), driven.count());
    EXPECT_LT(stood.count(), 1.0);
    EXPECT_GT(taken.count(), 1.9) << "its last heartbeat was at most a second old";
    EXPECT_LT(taken.count(), 6.0);
}

TEST_F(Grants, OrUntilTheHolderConsents) {
    const auto otherNode = nodeIn(m_domain);
    ControlStation first(*m_node, m_description, {"a", "Left desk", {}});
    ControlStation second(*otherNode, m_description, {"b", "Right desk", {}});
    first.ask();
    ASSERT_TRUE(waitUntil([&] { return first.mayDrive(); }));
    // Who has not heard of the holder takes what it asks for, and the later term is right.
    ASSERT_TRUE(waitUntil([&] { return second.view().holder == "a"; }));
    second.ask();
    ASSERT_TRUE(waitUntil([&] { return first.view().requestedBy == "b"; }));
    EXPECT_EQ(first.view().requestedByTitle, "Right desk");
    first.keeper().answerRequest(driveGrant("kurt3d"), false);
    ASSERT_TRUE(waitUntil([&] { return second.view().refusedBy == "a"; }));
    ASSERT_TRUE(first.driveUntil(0.3, [&] { return m_robot.speed() > 0.0; }));
    second.ask();
    ASSERT_TRUE(waitUntil([&] { return first.view().requestedBy == "b"; }));
    const auto consented = now();
    first.keeper().answerRequest(driveGrant("kurt3d"), true);
    ASSERT_TRUE(waitUntil([&] { return second.mayDrive() && m_robot.commands().holder() == "b"; }));
    const Seconds took = now() - consented;
    std::printf("consent: the robot obeys the second station after %.3f s\n", took.count());
    EXPECT_LT(took.count(), 2.0);
    EXPECT_EQ(m_robot.speed(), 0.0) << "nobody has pushed the second one's stick";
    ASSERT_TRUE(second.driveUntil(-0.3, [&] { return m_robot.speed() < 0.0; }));
    EXPECT_FALSE(first.mayDrive());
}

TEST_F(Grants, ARestartedStationHasItsGrantBackAtOnce) {
    const auto otherNode = nodeIn(m_domain);
    const auto waiting = must(GrantKeeper::create(*otherNode, {"0", "Waits for its chance", {}}));
    auto before = stationProcess("b", "5");
    ASSERT_TRUE(waitUntil([&] { return m_robot.speed() > 0.0; })) << before->out();
    ASSERT_TRUE(waitUntil([&] { return waiting->view(driveGrant("kurt3d")).holder == "b"; }));
    waiting->requestGrant(driveGrant("kurt3d"));
    before->signal(SIGKILL);
    before->wait();
    const auto restarted = now();
    const auto after = stationProcess("b", "5", "-0.3");
    ASSERT_TRUE(waitUntil([&] { return after->out().find("ready") != std::string::npos; }));
    const Seconds started = now() - restarted;
    ASSERT_TRUE(waitUntil([&] { return m_robot.speed() < 0.0; })) << after->out();
    const Seconds drove = now() - restarted;
    std::printf("restarted: up after %.2f s, the robot moves again after %.2f s\n", started.count(),
                drove.count());
    EXPECT_LT(drove.count() - started.count(), 2.5) << "no waiting for silence";
    EXPECT_FALSE(waiting->mayAct(driveGrant("kurt3d")));
}

TEST_F(Grants, OfTwoThatAskInTheSameMomentOneGetsIt) {
    const auto otherNode = nodeIn(m_domain);
    ControlStation first(*m_node, m_description, {"a", "Left desk", {}});
    ControlStation second(*otherNode, m_description, {"b", "Right desk", {}});
    first.ask();
    second.ask();
    // For a moment both may believe it; the robot obeys one of them then.
    auto agreed = now();
    EXPECT_TRUE(waitUntil([&] {
        const bool one = first.mayDrive() != second.mayDrive() &&
                         m_robot.commands().holder() == (first.mayDrive() ? "a" : "b");
        if (!one) agreed = now();
        return now() - agreed > 2s;
    }));
}

TEST_F(Grants, WhoEndsInOrderLeavesItToOthersAndRemembersIt) {
    std::vector<HeldGrant> remembered;
    std::mutex mutex;
    auto keeper = must(
        GrantKeeper::create(*m_node, {"a", "Left desk", {}}, {.onHeld = [&](std::vector<HeldGrant> held) {
            const std::scoped_lock lock(mutex);
            remembered = std::move(held);
        }}));
    keeper->requestGrant(driveGrant("kurt3d"));
    ASSERT_TRUE(waitUntil([&] { return m_robot.commands().holder() == "a"; }));
    keeper.reset();
    ASSERT_TRUE(waitUntil([&] { return m_robot.commands().holder().empty(); }));
    ASSERT_EQ(remembered.size(), 1U);
    const auto again = must(GrantKeeper::create(*m_node, {"a", "Left desk", remembered}));
    EXPECT_TRUE(waitUntil([&] { return m_robot.commands().holder() == "a"; }, 1s));
}

}  // namespace
}  // namespace leitstand::test
