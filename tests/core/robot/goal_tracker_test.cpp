#include "core/robot/services/goal_tracker.h"

#include <cmath>
#include <vector>

#include <gmock/gmock.h>

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;
using Status = GoalTracker::Status;

constexpr SteadyTime Start{100s};

GoalId id(std::uint8_t number) {
    GoalId id{};
    id.front() = number;
    return id;
}

/// A tracker of goal 1, which was asked at Start.
GoalTracker asked() {
    GoalTracker goals;
    goals.asked(id(1), Start);
    return goals;
}

void report(GoalTracker& goals, const GoalId& goal, Status status) {
    const std::vector<GoalTracker::Report> all = {{id(9), Status::Aborted}, {goal, status}};
    goals.reported(all);
}

GoalStage stageOf(const GoalTracker& goals, SteadyTime now = Start) {
    return goals.view(now).stage;
}

TEST(GoalTracker, FollowsAGoalToItsEnd) {
    GoalTracker goals;
    EXPECT_EQ(stageOf(goals), GoalStage::None);
    EXPECT_FALSE(goals.isOpen(Start));
    goals.asked(id(1), Start);
    EXPECT_EQ(stageOf(goals), GoalStage::Asked);
    EXPECT_TRUE(goals.isOpen(Start));
    goals.answered(id(1), true);
    EXPECT_EQ(stageOf(goals), GoalStage::UnderWay);
    goals.progressed(id(1), 3.2, 12.0, 1);
    const NavigationView view = goals.view(Start + 1h);
    EXPECT_EQ(view.stage, GoalStage::UnderWay) << "however long it takes";
    EXPECT_EQ(view.metresLeft, 3.2);
    EXPECT_EQ(view.secondsLeft, 12.0);
    EXPECT_EQ(view.recoveries, 1);
    report(goals, id(1), Status::Succeeded);
    EXPECT_EQ(stageOf(goals), GoalStage::Arrived);
    report(goals, id(1), Status::Aborted);
    EXPECT_EQ(stageOf(goals), GoalStage::Arrived) << "an end is an end";
}

TEST(GoalTracker, TellsHowItEnds) {
    for (const auto& [status, stage] :
         {std::pair(Status::Succeeded, GoalStage::Arrived), std::pair(Status::Canceled, GoalStage::Cancelled),
          std::pair(Status::Aborted, GoalStage::Failed)}) {
        GoalTracker goals = asked();
        report(goals, id(1), status);
        EXPECT_EQ(stageOf(goals), stage);
        EXPECT_FALSE(goals.isOpen(Start));
    }
    GoalTracker refused = asked();
    refused.answered(id(1), false);
    EXPECT_EQ(stageOf(refused), GoalStage::Refused);
}

TEST(GoalTracker, AnAnswerThatIsLostIsMadeUpForByTheStatus) {
    GoalTracker goals = asked();
    EXPECT_EQ(stageOf(goals, Start + 3s), GoalStage::Asked);
    EXPECT_EQ(stageOf(goals, Start + 3001ms), GoalStage::Unanswered);
    EXPECT_FALSE(goals.isOpen(Start + 4s));
    report(goals, id(1), Status::Executing);
    EXPECT_EQ(stageOf(goals, Start + 5s), GoalStage::UnderWay);
}

TEST(GoalTracker, WhatBelongsToOthersChangesNothing) {
    GoalTracker goals = asked();
    goals.answered(id(2), true);
    goals.progressed(id(2), 1.0, 1.0, 0);
    report(goals, id(2), Status::Succeeded);
    EXPECT_EQ(stageOf(goals), GoalStage::Asked);
    EXPECT_TRUE(std::isnan(goals.view(Start).metresLeft));
    goals.answered(id(1), true);
    goals.asked(id(2), Start + 1s);
    report(goals, id(1), Status::Aborted);
    EXPECT_EQ(stageOf(goals), GoalStage::Asked) << "the newer goal replaced it";
}

TEST(GoalTracker, AGoalThatIsCancelledMayStillArrive) {
    GoalTracker goals = asked();
    goals.answered(id(1), true);
    goals.cancelling();
    EXPECT_EQ(stageOf(goals), GoalStage::Cancelling);
    report(goals, id(1), Status::Executing);
    EXPECT_EQ(stageOf(goals), GoalStage::Cancelling);
    report(goals, id(1), Status::Succeeded);
    EXPECT_EQ(stageOf(goals), GoalStage::Arrived);
    goals.cancelling();
    EXPECT_EQ(stageOf(goals), GoalStage::Arrived);
}

TEST(GoalTracker, FiguresThatAreNoneAreNotShown) {
    GoalTracker goals = asked();
    for (const double odd : {-1.0, 1e30, std::nan(""), HUGE_VAL}) {
        goals.progressed(id(1), odd, odd, -3);
        EXPECT_TRUE(std::isnan(goals.view(Start).metresLeft)) << odd;
        EXPECT_TRUE(std::isnan(goals.view(Start).secondsLeft)) << odd;
        EXPECT_EQ(goals.view(Start).recoveries, 0);
    }
}

}  // namespace
}  // namespace leitstand::test
