#include "core/robot/joints/joint_control.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/pose.h"
#include "core/event/motion_samples.h"
#include "core/robot/joints/joint_message.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;
using testing::DoubleNear;
using testing::ElementsAre;

constexpr JointConditions May{true, false}, MayNot{}, Stopped{false, true}, Lost{false, false, false};

JointGroup flippers(JointCommandMode mode = JointCommandMode::Position) {
    JointGroup group;
    group.name = "flippers";
    group.mode = mode;
    for (const char* name : {"left", "right"}) {
        MovedJoint joint;
        joint.name = name;
        joint.lower = degrees(-60);
        joint.upper = degrees(90);
        joint.rate = degrees(40);
        group.joints.push_back(joint);
    }
    group.joints[1].reversed = true;
    group.joints[1].lower = degrees(-90);
    group.joints[1].upper = degrees(60);
    group.axes = {{"both", {0, 1}}, {"left", {0}}};
    group.presets = {{"up", {degrees(80), degrees(-80)}}, {"flat", {0.0, 0.0}}};
    return group;
}

/// Joints that follow what they are told, as fast as they may, and a control that moves them.
class Moved {
public:
    explicit Moved(JointGroup group) : control(std::move(group)), at(control.group().joints.size(), 0.0) {}

    /// One twentieth of a second.
    std::optional<JointSetpoints> step(const JointConditions& conditions = May) {
        now += 50ms;
        if (reports) {
            JointSample sample;
            sample.names = {"wheel", "left", "right"};
            sample.positions = {7.0, at[0], at[1]};
            control.reported(sample, now);
        }
        if (share) control.move(0, *share, now);
        auto sent = control.due(conditions, now);
        if (sent) last = sent;
        for (std::size_t i = 0; last && !blocked && i < at.size(); ++i) {
            const double step = 0.05 * control.group().joints[i].rate;
            at[i] += last->mode == JointCommandMode::Velocity
                         ? 0.05 * last->values[i]
                         : std::clamp(last->values[i] - at[i], -step, step);
        }
        return sent;
    }
    void steps(int count, const JointConditions& conditions = May) {
        for (int i = 0; i < count; ++i) (void)step(conditions);
    }

    JointControl control;
    std::vector<double> at;
    std::optional<JointSetpoints> last;
    std::optional<double> share;
    bool reports = true, blocked = false;
    SteadyTime now = SteadyTime(1000s);
};

TEST(JointControl, MovesAnAxisUpAtItsRateEachJointInItsOwnDirection) {
    Moved joints(flippers());
    joints.share = 0.0;
    joints.step();
    joints.share = 1.0;
    joints.steps(21);
    EXPECT_NEAR(joints.at[0], degrees(40), degrees(4)) << "a second";
    EXPECT_NEAR(joints.at[1], degrees(-40), degrees(4));
    joints.steps(40);
    EXPECT_NEAR(joints.at[0], degrees(90), 1e-9) << "its limit";
    EXPECT_NEAR(joints.at[1], degrees(-90), 1e-9);
}

TEST(JointControl, AMotionThatIsNotRenewedEndsAndMustBeLetGo) {
    for (const JointCommandMode mode : {JointCommandMode::Position, JointCommandMode::Velocity}) {
        Moved joints(flippers(mode));
        joints.share = 0.0;
        joints.step();
        joints.share = 0.5;
        joints.steps(5);
        joints.share.reset();  // the window hangs
        joints.steps(6);
        const double there = joints.at[0];
        EXPECT_GT(there, degrees(2));
        joints.share = 0.5;  // it is back, with the key still held
        joints.steps(10);
        EXPECT_DOUBLE_EQ(joints.at[0], there);
        joints.share = 0.0;
        joints.step();
        joints.share = 0.5;
        joints.steps(5);
        EXPECT_GT(joints.at[0], there + degrees(2));
    }
}

TEST(JointControl, VelocitiesEndWithZerosForAWhile) {
    Moved joints(flippers(JointCommandMode::Velocity));
    joints.share = 0.0;
    EXPECT_EQ(joints.step(), std::nullopt) << "nothing was moved";
    joints.share = 1.0;
    EXPECT_THAT(joints.step()->values,
                ElementsAre(DoubleNear(degrees(40), 1e-9), DoubleNear(degrees(-40), 1e-9)));
    joints.share = 0.0;
    for (int i = 0; i < 10; ++i) EXPECT_THAT(joints.step()->values, ElementsAre(0.0, 0.0)) << i;
    joints.steps(2);
    EXPECT_EQ(joints.step(), std::nullopt) << "others may move them now";
}

TEST(JointControl, VelocitiesStopAtTheLimitsThatAreKnown) {
    Moved joints(flippers(JointCommandMode::Velocity));
    joints.share = 0.0;
    joints.step();
    joints.share = 1.0;
    joints.steps(200);
    EXPECT_LT(joints.at[0], degrees(93));
    EXPECT_THAT(joints.last->values, ElementsAre(0.0, 0.0));
    joints.share = -1.0;
    joints.step();
    EXPECT_LT(joints.last->values[0], 0.0) << "back it may";
}

TEST(JointControl, ApproachesAPresetAndEndsThere) {
    for (const JointCommandMode mode : {JointCommandMode::Position, JointCommandMode::Velocity}) {
        Moved joints(flippers(mode));
        joints.step();
        joints.control.goTo(0, joints.now);
        joints.steps(20);
        EXPECT_LT(joints.at[0], degrees(45)) << "no faster than its rate";
        EXPECT_EQ(joints.control.motion(), JointMotion::ToPreset);
        joints.steps(60);
        EXPECT_EQ(joints.control.motion(), JointMotion::Still);
        EXPECT_NEAR(joints.at[0], degrees(80), degrees(2));
        EXPECT_NEAR(joints.at[1], degrees(-80), degrees(2));
        joints.steps(12);
        EXPECT_EQ(joints.step(), std::nullopt);
    }
}

TEST(JointControl, APresetEndsWithAnyOtherWishAStopOrTheGrant) {
    for (const auto& conditions : {MayNot, Stopped}) {
        Moved joints(flippers(JointCommandMode::Velocity));
        joints.step();
        joints.control.goTo(0, joints.now);
        joints.steps(10);
        joints.steps(2, conditions);
        EXPECT_THAT(joints.last->values, ElementsAre(0.0, 0.0));
        EXPECT_EQ(joints.control.motion(), JointMotion::Still);
        joints.last.reset();
        joints.steps(5);
        EXPECT_TRUE(!joints.last || joints.last->values == std::vector({0.0, 0.0})) << "it does not go on";
    }
    Moved joints(flippers());
    joints.step();
    joints.control.goTo(0, joints.now);
    joints.steps(10);
    joints.control.halt();
    const double there = joints.last->values[0];
    joints.steps(10);
    EXPECT_DOUBLE_EQ(joints.last->values[0], there);
}

TEST(JointControl, WhileAStopIsInForceVelocitiesAreZeroAndPositionsHeldAtFirst) {
    Moved turning(flippers(JointCommandMode::Velocity));
    for (int i = 0; i < 100; ++i) EXPECT_THAT(turning.step(Stopped)->values, ElementsAre(0.0, 0.0));
    Moved held(flippers());
    held.at = {0.3, 0.2};
    held.step();
    EXPECT_THAT(held.step(Stopped)->values, ElementsAre(0.3, 0.2)) << "also what another program moves";
    held.steps(15, Stopped);
    EXPECT_EQ(held.step(Stopped), std::nullopt) << "without power an arm sinks: it must not leap later";
    held.at = {0.1, 0.1};
    held.last.reset();
    held.share = 0.0;
    held.steps(2);
    held.share = 1.0;
    EXPECT_NEAR(held.step()->values[0], 0.1, degrees(3)) << "from where it is now";
}

TEST(JointControl, AfterAGapOfTheLinkZerosAreSentOnceItIsBack) {
    Moved joints(flippers(JointCommandMode::Velocity));
    joints.share = 0.0;
    joints.step();
    joints.share = 1.0;
    joints.steps(3);
    joints.share = 0.0;
    for (int i = 0; i < 100; ++i) {
        joints.now += 50ms;
        EXPECT_TRUE(joints.control.due(Lost, joints.now)) << "none of these arrives";
    }
    EXPECT_TRUE(joints.control.isMoving()) << "the station must not leave its domain now";
    EXPECT_THAT(joints.step()->values, ElementsAre(0.0, 0.0)) << "the link is back";
    joints.steps(15);
    EXPECT_EQ(joints.step(), std::nullopt);
    EXPECT_FALSE(joints.control.isMoving());
}

TEST(JointControl, AStopThatStandsIsNoMotion) {
    for (const JointCommandMode mode : {JointCommandMode::Position, JointCommandMode::Velocity}) {
        Moved joints(flippers(mode));
        joints.share = 0.0;
        joints.step();
        joints.share = 1.0;
        joints.steps(3);
        EXPECT_TRUE(joints.control.isMoving());
        joints.share = 0.0;
        joints.steps(20, Stopped);
        EXPECT_FALSE(joints.control.isMoving()) << "the station may join its domain again";
    }
}

TEST(JointControl, ZerosAreSentUntilTheJointsAreSeenToStand) {
    Moved joints(flippers(JointCommandMode::Velocity));
    joints.share = 0.0;
    joints.step();
    joints.share = 1.0;
    joints.steps(3);
    joints.share = 0.0;
    for (int i = 0; i < 40; ++i) {
        joints.at[0] += degrees(1);  // the zeros are lost
        EXPECT_TRUE(joints.step()) << i;
    }
    joints.steps(6);
    EXPECT_EQ(joints.step(), std::nullopt) << "they arrived";
}

TEST(JointControl, AJointThatLagsEndsWhereItIs) {
    Moved joints(flippers());
    joints.share = 0.0;
    joints.step();
    joints.blocked = true;
    joints.share = 1.0;
    joints.steps(20);
    EXPECT_GT(joints.last->values[0], degrees(15));
    joints.share = 0.0;
    EXPECT_THAT(joints.step()->values, ElementsAre(0.0, 0.0)) << "it does not go on, and presses no more";
}

TEST(JointControl, WhatOthersMovedMeanwhileStaysThere) {
    Moved joints(flippers());
    joints.share = 0.0;
    joints.step();
    joints.share = 1.0;
    joints.steps(5);
    joints.share = 0.0;
    joints.steps(20);
    joints.at[1] -= degrees(12);
    joints.last.reset();
    joints.step();
    joints.control.move(1, 0.0, joints.now);
    joints.control.move(1, 1.0, joints.now);  // the left one alone
    joints.share.reset();
    const double right = joints.at[1];
    EXPECT_NEAR(joints.step()->values[1], right, 1e-9);
}

TEST(JointControl, NothingBegunInTheLastMomentOfAStopMoves) {
    Moved joints(flippers());
    joints.at = {0.3, 0.2};
    joints.step();
    joints.steps(3, Stopped);
    joints.control.goTo(1, joints.now);
    joints.last.reset();
    joints.steps(20);
    EXPECT_EQ(joints.last, std::nullopt);
    EXPECT_THAT(joints.at, ElementsAre(0.3, 0.2));
}

TEST(JointControl, WhereAKnownJointFallsSilentItsLimitWouldNotHold) {
    Moved joints(flippers(JointCommandMode::Velocity));
    joints.share = 0.0;
    joints.step();
    joints.share = 1.0;
    joints.steps(5);
    joints.reports = false;
    joints.steps(25);
    EXPECT_EQ(joints.control.motion(), JointMotion::Unreported);
    EXPECT_THAT(joints.last->values, ElementsAre(0.0, 0.0));
}

TEST(JointControl, WhatIsHeldThroughAStopMovesNothingAfterIt) {
    Moved joints(flippers());
    joints.share = 0.0;
    joints.step();
    joints.share = 1.0;
    joints.steps(3);
    joints.steps(20, Stopped);
    joints.last.reset();
    joints.steps(10);
    EXPECT_EQ(joints.last, std::nullopt);
}

TEST(JointControl, ABlockedJointIsGivenUpAndDoesNotLeapWhenItComesFree) {
    Moved joints(flippers());
    joints.step();
    joints.blocked = true;
    joints.control.goTo(0, joints.now);
    for (int i = 0; i < 40; ++i) {
        joints.step();
        EXPECT_LE(joints.last->values[0], degrees(20) + 1e-9) << "half a second of its rate ahead, at most";
    }
    joints.steps(30);
    EXPECT_EQ(joints.control.motion(), JointMotion::Blocked);
    EXPECT_THAT(joints.last->values, ElementsAre(0.0, 0.0)) << "it presses no more";
}

TEST(JointControl, WithoutPositionsOnlyVelocitiesByHandMove) {
    Moved joints(flippers());
    joints.reports = false;
    joints.share = 0.0;
    joints.step();
    joints.share = 1.0;
    EXPECT_EQ(joints.step(), std::nullopt);
    EXPECT_EQ(joints.control.motion(), JointMotion::Unreported);
    Moved blind(flippers(JointCommandMode::Velocity));
    blind.reports = false;
    blind.share = 0.0;
    blind.step();
    blind.share = 1.0;
    EXPECT_TRUE(blind.step().has_value());
    blind.share = 0.0;
    blind.step();
    blind.control.goTo(0, blind.now);
    EXPECT_EQ(blind.control.motion(), JointMotion::Unreported);
}

TEST(JointControl, APresetEndsWhereTheRobotFallsSilent) {
    Moved joints(flippers());
    joints.step();
    joints.control.goTo(0, joints.now);
    joints.steps(5);
    joints.reports = false;
    joints.steps(25);
    EXPECT_EQ(joints.control.motion(), JointMotion::Unreported);
    EXPECT_LT(joints.last->values[0], degrees(45)) << "not driven on blindly";
}

TEST(JointControl, AJointThatTurnsForEverTakesTheNearerWay) {
    JointGroup group = flippers();
    for (MovedJoint& joint : group.joints) joint.lower = joint.upper = std::nullopt;
    Moved joints(group);
    joints.at = {degrees(725), degrees(-350)};
    joints.step();
    joints.control.goTo(1, joints.now);
    joints.steps(40);
    EXPECT_NEAR(joints.at[0], degrees(720), degrees(2));
    EXPECT_NEAR(joints.at[1], degrees(-360), degrees(2));
}

TEST(JointControl, NumbersThatAreNoneMoveNothing) {
    Moved joints(flippers());
    JointSample sample;
    sample.names = {"left", "right"};
    sample.positions = {std::numeric_limits<double>::quiet_NaN(), 0.0};
    joints.control.reported(sample, joints.now);
    EXPECT_EQ(joints.control.position(0, joints.now), std::nullopt);
    joints.control.move(7, 1.0, joints.now);
    joints.control.goTo(9, joints.now);
    joints.control.move(0, std::numeric_limits<double>::quiet_NaN(), joints.now);
    EXPECT_EQ(joints.step(), std::nullopt);
}

TEST(JointMessage, EachTypeSaysTheSame) {
    const JointGroup group = flippers();
    const JointSetpoints positions{JointCommandMode::Position, {0.1, 0.2}};
    const Sample trajectory = jointMessage(group, positions, "trajectory_msgs/msg/JointTrajectory");
    const auto& points = trajectory.get<JointTrajectorySample>().points;
    EXPECT_THAT(trajectory.get<JointTrajectorySample>().names, ElementsAre("left", "right"));
    ASSERT_EQ(points.size(), 1U);
    EXPECT_THAT(points[0].positions, ElementsAre(0.1, 0.2));
    EXPECT_GT(points[0].fromStart, 0ns) << "joint_trajectory_controller refuses one that is over";
    const Sample numbers = jointMessage(group, positions, "std_msgs/msg/Float64MultiArray");
    EXPECT_THAT(numbers.get<NumbersSample>().values, ElementsAre(0.1, 0.2));
    const Sample state =
        jointMessage(group, {JointCommandMode::Velocity, {0.3, 0.4}}, "sensor_msgs/msg/JointState");
    EXPECT_THAT(state.get<JointSample>().velocities, ElementsAre(0.3, 0.4));
    EXPECT_THAT(state.get<JointSample>().positions, testing::IsEmpty());
}

}  // namespace
}  // namespace leitstand::test
