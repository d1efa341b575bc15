#include "core/mission/score/score.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/event/find_sample.h"
#include "core/event/station_samples.h"
#include "core/mission/state/find_state.h"
#include "core/mission/state/scan_state.h"

namespace leitstand {
namespace {

using Kind = FindSample::Kind;
using State = VictimSign::State;
using testing::SizeIs;

ScoreProfile rules() {
    ScoreProfile profile;
    profile.areas = {{"yellow", 0.5}, {"red", 1.0}};
    profile.points = {{ScoreItem::Map, 20},   {ScoreItem::Location, 10}, {ScoreItem::Form, 2},
                      {ScoreItem::Motion, 2}, {ScoreItem::Heat, 2},      {ScoreItem::Sound, 2},
                      {ScoreItem::Co2, 2},    {ScoreItem::Situation, 5}, {ScoreItem::Tag, 5}};
    profile.areaBump = 5;
    profile.victimBump = 20;
    profile.autonomous = 2.0;
    profile.semiAutonomous = 1.5;
    profile.hazard = 5;
    return profile;
}

FindSample whole(std::uint32_t number, const std::string& area) {
    FindSample victim;
    victim.number = number;
    victim.status = FindSample::Status::Confirmed;
    victim.area = area;
    victim.positionInMap = {1.0, 2.0, 0.3};
    for (VictimSign* sign : {&victim.form, &victim.motion, &victim.heat, &victim.sound, &victim.co2})
        sign->state = State::Present;
    victim.situation = "void";
    victim.tag = "R-17";
    return victim;
}

MissionState missionOf(const std::vector<FindSample>& finds) {
    MissionState state;
    for (const FindSample& find : finds)
        state.finds.edit()[{find.kind, find.number}] = {find.number, find.number, find};
    return state;
}

TEST(Score, AVictimThatIsToldWholeBringsAllPointsOfItsArea) {
    const auto result = score(rules(), missionOf({whole(1, "red"), whole(2, "yellow")}));
    EXPECT_DOUBLE_EQ(result.finds[0].total, 50.0);
    EXPECT_DOUBLE_EQ(result.finds[1].total, 25.0);
    EXPECT_DOUBLE_EQ(result.score, 75.0);
    EXPECT_THAT(result.advice, testing::IsEmpty());
}

TEST(Score, TellsWhatOneMoreSignWouldBringLargestFirst) {
    FindSample victim = whole(1, "red");
    victim.sound.state = State::Unknown;
    victim.tag.clear();
    FindSample hypothesis = whole(2, "yellow");
    hypothesis.status = FindSample::Status::Hypothesis;
    const auto result = score(rules(), missionOf({victim, hypothesis}));
    EXPECT_DOUBLE_EQ(result.score, 43.0);
    ASSERT_THAT(result.advice, SizeIs(3));
    EXPECT_EQ(result.advice[0].name, "V2");
    EXPECT_FALSE(result.advice[0].item) << "confirm it";
    EXPECT_DOUBLE_EQ(result.advice[0].gain, 25.0);
    EXPECT_EQ(result.advice[1].item, ScoreItem::Tag);
    EXPECT_DOUBLE_EQ(result.advice[2].gain, 2.0);
    FindSample stated = victim;
    stated.sound.state = State::Absent;
    EXPECT_DOUBLE_EQ(score(rules(), missionOf({stated, hypothesis})).score - result.score, 2.0)
        << "the advice keeps its promise; to know that a victim is silent counts as much";
}

TEST(Score, OperatorsDivideAsTheRulesSay) {
    auto state = missionOf({whole(1, "red")});
    state.info = latestPtr(Latest<MissionInfoSample>{1, {}, {.operators = 2}});
    auto profile = rules();
    profile.operators = OperatorRule::SquaredOfMore;
    EXPECT_DOUBLE_EQ(score(profile, state).score, 50.0 / 9.0);
    profile.operators = OperatorRule::Count;
    EXPECT_DOUBLE_EQ(score(profile, state).score, 25.0);
}

TEST(Score, WhatNoAreaIsToldOfIsInTheMissions) {
    auto state = missionOf({whole(1, "")});
    EXPECT_DOUBLE_EQ(score(rules(), state).score, 50.0) << "an unknown area weighs one";
    state.info = latestPtr(Latest<MissionInfoSample>{1, {}, {.area = "yellow"}});
    EXPECT_DOUBLE_EQ(score(rules(), state).score, 25.0);
}

TEST(Score, AutonomyCountsByWhereItWasComputed) {
    FindSample driven = whole(1, "red"), itself = whole(2, "red");
    driven.autonomous = itself.autonomous = true;
    itself.evidence = {{"sighting", "/kurt3d/sightings", 9, {}}};
    const auto result = score(rules(), missionOf({driven, itself}));
    EXPECT_DOUBLE_EQ(result.finds[0].total, 75.0);
    EXPECT_DOUBLE_EQ(result.finds[1].total, 100.0);
}

TEST(Score, DiscardedFindsCountNothingAndHazardsTheirOwn) {
    FindSample gone = whole(1, "red"), sign = whole(1, "red");
    gone.status = FindSample::Status::Discarded;
    sign.kind = Kind::Hazard;
    const auto result = score(rules(), missionOf({gone, sign}));
    ASSERT_THAT(result.finds, SizeIs(1));
    EXPECT_EQ(result.finds[0].name, "H1");
    EXPECT_DOUBLE_EQ(result.score, 5.0);
}

TEST(Score, ContactsNearAConfirmedVictimAreWithTheVictim) {
    auto state = missionOf({whole(1, "red")});
    KeyScanState scan;
    scan.entry = {.id = 1, .robot = "kurt3d", .stamp = Time(std::chrono::seconds(1))};
    scan.entry.sensorInOdom = Pose::Identity();
    scan.pose.scan = 1;
    scan.pose.scanInMap = Pose(Eigen::Translation3d(1.0, 0.0, 0.0));
    state.keyScans.edit()[1] = scan;
    RobotState& robot = state.robots["kurt3d"].edit();
    const Pose away = Pose::Identity(), near = Pose(Eigen::Translation3d(0.0, 1.6, 0.0));
    robot.contacts = {{5, Time(std::chrono::seconds(2)), "front", 2, away},
                      {6, Time(std::chrono::seconds(3)), "front", 1, near},
                      {7, Time(std::chrono::seconds(4)), "front", 1, std::nullopt}};
    const auto result = score(rules(), state);
    EXPECT_EQ(result.areaBumps, 3U);
    EXPECT_EQ(result.victimBumps, 1U);
    EXPECT_DOUBLE_EQ(result.penalty, 35.0);
    EXPECT_DOUBLE_EQ(result.score, 15.0);
}

TEST(Score, AnAreaThatTheRulesDoNotWeighIsNamed) {
    ScoreProfile flat = rules();
    flat.areas.clear();
    const auto result = score(flat, missionOf({whole(1, "red"), whole(2, "")}));
    EXPECT_EQ(result.unweighed, std::set<std::string>{"red"});
    EXPECT_DOUBLE_EQ(result.finds[0].weight, 1.0);
    EXPECT_TRUE(score(rules(), missionOf({whole(1, "red")})).unweighed.empty());
}

TEST(Score, OdometryLiesWhereTheScanBeforeTheMomentSaid) {
    MissionState state;
    for (std::uint64_t id : {1, 2}) {
        KeyScanState& scan = state.keyScans.edit()[id];
        scan.entry = {.id = id, .robot = "kurt3d", .stamp = Time(std::chrono::seconds(10 * id))};
        scan.entry.sensorInOdom = Pose(Eigen::Translation3d(1.0, 0.0, 0.0));
        scan.pose.scanInMap = Pose(Eigen::Translation3d(static_cast<double>(id), 0.0, 0.0));
    }
    const auto x = [&](int seconds) {
        return odomInMap(state, "kurt3d", Time(std::chrono::seconds(seconds)))->translation().x();
    };
    EXPECT_DOUBLE_EQ(x(15), 0.0);
    EXPECT_DOUBLE_EQ(x(25), 1.0);
    EXPECT_DOUBLE_EQ(x(5), 0.0) << "before the first the first counts";
    EXPECT_FALSE(odomInMap(state, "crawler", Time()));
}

}  // namespace
}  // namespace leitstand
