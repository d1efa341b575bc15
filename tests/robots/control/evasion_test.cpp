#include "robots/control/driving/evasion.h"

#include <chrono>

#include <gtest/gtest.h>

#include "robots/control/driving/felt_obstacles.h"

namespace leitstand::test {
namespace {

constexpr DriveVelocity Ahead{0.3, 0.0, 0.0}, Back{-0.2, 0.0, 0.0};

Time at(double seconds) {
    return Time(std::chrono::milliseconds(static_cast<std::int64_t>(1000.0 * seconds)));
}

Pose placed(double x, double yaw = 0.0) {
    return poseFrom({x, 0.0, 0.0}, 0.0, 0.0, yaw);
}

TEST(Evasion, NothingIsFeltNothingIsDone) {
    Evasion evasion;
    evasion.lean(0.15);
    const EvasionStep step = evasion.step(Ahead, placed(0.0), at(0.0));
    EXPECT_FALSE(step.velocity || step.felt || step.failed);
    EXPECT_EQ(evasion.caution(), 1.0);
}

TEST(Evasion, BacksAWayOutOfWhatItTouchedAndThenLetsGo) {
    Evasion evasion;
    evasion.bumped(BodySide::Front);
    EvasionStep step = evasion.step(Ahead, placed(2.0), at(0.0));
    ASSERT_TRUE(step.velocity && step.felt);
    EXPECT_EQ(*step.felt, BodySide::Front);
    EXPECT_TRUE(step.touched);
    EXPECT_LT(step.velocity->forward, -0.05);
    step = evasion.step(Ahead, placed(1.8), at(2.0));
    EXPECT_TRUE(step.velocity);
    EXPECT_FALSE(step.felt) << "it was told";
    step = evasion.step(Ahead, placed(1.6), at(4.0));
    EXPECT_FALSE(step.velocity);
    EXPECT_FALSE(evasion.isActive());
}

TEST(Evasion, WhatIsBehindOrBesideIsLeftTheOtherWay) {
    Evasion evasion;
    evasion.bumped(BodySide::Rear);
    EXPECT_GT(evasion.step(Back, placed(0.0), at(0.0)).velocity->forward, 0.0);
    evasion.reset();
    evasion.bumped(BodySide::Left);
    EXPECT_LT(evasion.step(Ahead, placed(0.0), at(1.0)).velocity->forward, 0.0);
    evasion.reset();
    evasion.bumped(BodySide::Right);
    EXPECT_GT(evasion.step(Back, placed(0.0), at(2.0)).velocity->forward, 0.0);
}

TEST(Evasion, SomethingBehindTurnsItRound) {
    Evasion evasion;
    evasion.bumped(BodySide::Front);
    EXPECT_LT(evasion.step(Ahead, placed(0.0), at(0.0)).velocity->forward, 0.0);
    evasion.bumped(BodySide::Front);
    EXPECT_FALSE(evasion.step(Ahead, placed(0.0), at(0.1)).felt) << "it is on its way from there";
    evasion.bumped(BodySide::Rear);
    const EvasionStep step = evasion.step(Back, placed(-0.1), at(0.5));
    EXPECT_EQ(step.felt, BodySide::Rear);
    EXPECT_GT(step.velocity->forward, 0.0);
}

TEST(Evasion, LeaningSlowsItDownAndTurnsItBack) {
    Evasion evasion;
    evasion.lean(0.35);
    EXPECT_LT(evasion.caution(), 0.8);
    EXPECT_FALSE(evasion.step(Ahead, placed(0.0), at(0.0)).velocity);
    evasion.lean(0.6);
    EXPECT_NEAR(evasion.caution(), 0.4, 1e-9);
    EvasionStep step = evasion.step(Ahead, placed(0.0), at(0.1));
    ASSERT_TRUE(step.velocity);
    EXPECT_LT(step.velocity->forward, 0.0);
    EXPECT_EQ(step.felt, BodySide::Front);
    EXPECT_FALSE(step.touched);
    (void)evasion.step(Ahead, placed(-0.4), at(3.0));
    step = evasion.step(Ahead, placed(-0.4), at(3.1));
    ASSERT_TRUE(step.velocity) << "it leans as before: the other way";
    EXPECT_GT(step.velocity->forward, 0.0);
}

TEST(Evasion, GivesUpAfterSomeTries) {
    Evasion evasion;
    evasion.lean(0.9);
    bool failed = false;
    double seconds = 0.0;
    for (; seconds < 60.0 && !failed; seconds += 0.1)
        failed = evasion.step(Ahead, placed(0.0), at(seconds)).failed;
    EXPECT_TRUE(failed);
    EXPECT_GT(seconds, 15.0);
    EXPECT_LT(seconds, 45.0);
}

TEST(FeltObstacles, StayInViewForFiveMinutesWhereTheyWere) {
    FeltObstacles felt;
    felt.add({0.3, 0.1}, placed(1.0, degrees(90)), at(0.0));
    felt.add({0.3, 0.11}, placed(1.0, degrees(90)), at(1.0));
    EXPECT_EQ(felt.count(), 1u) << "the same again";
    VirtualScanView view;
    felt.addTo(view, placed(1.0), at(2.0));
    ASSERT_EQ(view.obstacles.size(), 1u);
    EXPECT_LT((view.obstacles[0].where - Eigen::Vector2d(-0.11, 0.3)).norm(), 1e-9);
    view.obstacles.clear();
    felt.addTo(view, placed(1.0), at(302.0));
    EXPECT_TRUE(view.obstacles.empty());
}

}  // namespace
}  // namespace leitstand::test
