#include "core/robot/control/stop/service_stop.h"

#include <gmock/gmock.h>

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;
using Stage = StopServiceStatus::Stage;

const ServiceDescription EStop{
    .name = "/e_stop", .type = "std_srvs/srv/SetBool", .title = "E-stop", .stop = true};

/// A service and its clock.
class ServiceStops : public testing::Test {
protected:
    /// Steps the time by 10 ms until a call is due; empty after 10 s without one.
    std::optional<ServiceStop::Call> next(ServiceStop& stop) {
        for (const SteadyTime end = m_now + 10s; m_now < end; m_now += 10ms) {
            if (auto call = stop.due(m_now)) return call;
        }
        return std::nullopt;
    }
    static Stage stageOf(const ServiceStop& stop) { return stop.status().stage; }
    /// Stops @p stop and confirms it.
    void stopped(ServiceStop& stop) {
        stop.offered(true, true, m_now);
        stop.stop(m_now);
        const auto call = stop.due(m_now);
        ASSERT_TRUE(call);
        stop.answered(call->tag, {true, ""}, m_now);
        ASSERT_EQ(stageOf(stop), Stage::Stopped);
    }

    SteadyTime m_now{100s};
};

TEST_F(ServiceStops, AStopIsRepeatedUntilItIsConfirmed) {
    ServiceStop stop(EStop);
    stop.offered(true, true, m_now);
    EXPECT_FALSE(stop.due(m_now)) << "nobody stopped the robot";
    stop.stop(m_now);
    EXPECT_EQ(stop.status().title, "E-stop");
    const auto first = stop.due(m_now);
    ASSERT_TRUE(first);
    EXPECT_TRUE(first->request.value);
    const auto before = m_now;
    const auto second = next(stop);
    ASSERT_TRUE(second);
    EXPECT_EQ(m_now - before, 250ms);
    EXPECT_EQ(stageOf(stop), Stage::Asked);
    stop.answered(first->tag, {true, ""}, m_now);  // the first one was slow
    EXPECT_EQ(stageOf(stop), Stage::Stopped);
    EXPECT_FALSE(next(stop));
}

TEST_F(ServiceStops, NothingIsAskedOfNobody) {
    ServiceStop stop(EStop);
    stop.stop(m_now);
    EXPECT_FALSE(next(stop));
    EXPECT_FALSE(stop.status().offered);
    stop.offered(true, true, m_now);
    EXPECT_TRUE(next(stop)) << "somebody came";
    stop.offered(false, false, m_now);
    stop.release(m_now);
    EXPECT_EQ(stageOf(stop), Stage::Idle) << "a release waits for nobody";
    EXPECT_FALSE(next(stop));
}

TEST_F(ServiceStops, ARefusedStopIsAskedForAgainAndTold) {
    ServiceStop stop(EStop);
    stop.offered(true, true, m_now);
    stop.stop(m_now);
    stop.answered(stop.due(m_now)->tag, {false, "fuse blown"}, m_now);
    EXPECT_EQ(stageOf(stop), Stage::Asked);
    EXPECT_TRUE(stop.status().refused);
    EXPECT_EQ(stop.status().message, "fuse blown");
    const auto before = m_now;
    const auto again = next(stop);
    ASSERT_TRUE(again);
    EXPECT_EQ(m_now - before, 1s);
    stop.answered(again->tag, {true, ""}, m_now);
    EXPECT_EQ(stageOf(stop), Stage::Stopped);
    EXPECT_FALSE(stop.status().refused);
}

TEST_F(ServiceStops, ARestartedServerIsStoppedAgain) {
    ServiceStop stop(EStop);
    ASSERT_NO_FATAL_FAILURE(stopped(stop));
    stop.offered(true, false, m_now);
    EXPECT_FALSE(next(stop));
    stop.offered(true, true, m_now);
    EXPECT_TRUE(next(stop));
}

TEST_F(ServiceStops, AReleaseSetsTheOtherValue) {
    ServiceStop stop(EStop);
    ASSERT_NO_FATAL_FAILURE(stopped(stop));
    stop.release(m_now);
    EXPECT_TRUE(stop.isReleasing());
    const auto call = stop.due(m_now);
    ASSERT_TRUE(call);
    EXPECT_FALSE(call->request.value);
    stop.answered(call->tag, {true, ""}, m_now);
    EXPECT_EQ(stageOf(stop), Stage::Idle);
    EXPECT_FALSE(stop.takeRevoked());
    stop.release(m_now);
    EXPECT_FALSE(next(stop)) << "what is not stopped is not released";
}

TEST_F(ServiceStops, AnUnansweredReleaseIsRevoked) {
    ServiceStop stop(EStop);
    ASSERT_NO_FATAL_FAILURE(stopped(stop));
    stop.release(m_now);
    const auto release = stop.due(m_now);
    m_now += 2s;
    const auto call = stop.due(m_now);
    ASSERT_TRUE(call);
    EXPECT_TRUE(call->request.value) << "stopped again";
    EXPECT_TRUE(stop.takeRevoked());
    EXPECT_FALSE(stop.takeRevoked()) << "once";
    EXPECT_EQ(stop.refusal(), "E-stop did not answer the release: stopped again");
    stop.answered(release->tag, {true, "late"}, m_now);
    EXPECT_EQ(stageOf(stop), Stage::Asked) << "the answer to the release is no answer to the stop";
    stop.answered(call->tag, {true, ""}, m_now);
    EXPECT_EQ(stageOf(stop), Stage::Stopped);
}

TEST_F(ServiceStops, ARefusedReleaseIsRevokedWithItsReason) {
    ServiceStop stop(EStop);
    ASSERT_NO_FATAL_FAILURE(stopped(stop));
    stop.release(m_now);
    stop.answered(stop.due(m_now)->tag, {false, "button pressed"}, m_now);
    EXPECT_TRUE(stop.takeRevoked());
    EXPECT_EQ(stop.status().message, "button pressed");
    const auto call = next(stop);
    ASSERT_TRUE(call);
    EXPECT_TRUE(call->request.value);
    stop.answered(call->tag, {true, ""}, m_now);
    EXPECT_EQ(stop.refusal(), "E-stop refuses: button pressed") << "until the next command";
    stop.release(m_now);
    EXPECT_EQ(stop.refusal(), "");
}

TEST_F(ServiceStops, AnOlderAnswerEndsNoNewerStop) {
    ServiceStop stop(EStop);
    ASSERT_NO_FATAL_FAILURE(stopped(stop));
    stop.release(m_now);
    const auto release = stop.due(m_now);
    stop.stop(m_now);
    stop.answered(release->tag, {true, ""}, m_now);
    EXPECT_EQ(stageOf(stop), Stage::Asked);
}

TEST_F(ServiceStops, GoalsAreCancelledAndNotGivenBack) {
    ServiceStop stop({.name = "/navigate_to_pose/_action/cancel_goal",
                      .type = "action_msgs/srv/CancelGoal",
                      .stop = true});
    ASSERT_NO_FATAL_FAILURE(stopped(stop));
    stop.release(m_now);
    EXPECT_EQ(stageOf(stop), Stage::Idle);
    EXPECT_FALSE(next(stop));
}

TEST_F(ServiceStops, ATriggerForTheReleaseIsCalledThenOnly) {
    ServiceStop stop({.name = "/reset_e_stop", .type = "std_srvs/srv/Trigger", .stop = false});
    stop.offered(true, true, m_now);
    stop.stop(m_now);
    EXPECT_EQ(stageOf(stop), Stage::Stopped);
    EXPECT_FALSE(next(stop));
    stop.release(m_now);
    const auto call = next(stop);
    ASSERT_TRUE(call);
    stop.answered(call->tag, {false, "not now"}, m_now);
    EXPECT_TRUE(stop.takeRevoked());
    EXPECT_EQ(stageOf(stop), Stage::Stopped);
}

}  // namespace
}  // namespace leitstand::test
