#include "widgets/models/score/score_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/event/find_sample.h"
#include "core/mission/state/find_state.h"

namespace leitstand {
namespace {

using testing::SizeIs;

ScoreProfile rules() {
    ScoreProfile profile;
    profile.title = "RoboCup Rescue 2005";
    profile.version = "1.0";
    profile.points = {{ScoreItem::Location, 10.0}, {ScoreItem::Heat, 2.5}};
    profile.areaBump = 5.0;
    profile.areas = {{"yellow", 0.5}};
    profile.operators = OperatorRule::Count;
    profile.unconfirmed = {"points", "areas"};
    return profile;
}

MissionState mission() {
    MissionState state;
    FindSample victim;
    victim.number = 1;
    victim.status = FindSample::Status::Confirmed;
    victim.area = "yellow";
    state.finds.edit()[{victim.kind, 1U}] = {1, 1, victim};
    victim.number = 2;
    victim.status = FindSample::Status::Hypothesis;
    state.finds.edit()[{victim.kind, 2U}] = {2, 2, victim};
    state.robots["kurt3d"].edit().contacts = {{5, {}, "front", 2, std::nullopt}};
    state.info = latestPtr(Latest<MissionInfoSample>{3, {}, {.operators = 2}});
    return state;
}

TEST(ScoreText, SaysWhatEachBringsWhatItCostsAndByWhichRules) {
    const auto profile = rules();
    const auto text = scoreText(profile, score(profile, mission()), {});
    EXPECT_EQ(text.rules.toStdString(), "RoboCup Rescue 2005 · version 1.0 · 2 values unconfirmed");
    ASSERT_THAT(text.finds, SizeIs(4));
    EXPECT_EQ(text.finds[0].what.toStdString(), "V1 · area × 0.50");
    EXPECT_EQ(text.finds[0].points.toStdString(), "5");
    EXPECT_EQ(text.finds[0].items.toStdString(), "place\u00a010/10, heat\u00a00/2.5");
    EXPECT_EQ(text.finds[1].what.toStdString(), "V2, not confirmed");
    EXPECT_TRUE(text.finds[1].items.isEmpty()) << "it brings nothing yet";
    EXPECT_EQ(text.finds[2].what.toStdString(), "2 × touched the arena");
    EXPECT_EQ(text.finds[2].points.toStdString(), "−10");
    EXPECT_EQ(text.finds[3].points.toStdString(), "÷ 2");
    EXPECT_EQ(text.score.toStdString(), "−2.5 points");
    EXPECT_TRUE(text.left.isEmpty());
}

TEST(ScoreText, SaysWhereAnAreaChangesNothing) {
    auto profile = rules();
    profile.areas.clear();
    const auto text = scoreText(profile, score(profile, mission()), {});
    ASSERT_THAT(text.finds, SizeIs(5));
    EXPECT_EQ(text.finds[0].what.toStdString(), "V1");
    EXPECT_EQ(text.finds[2].what.toStdString(), "area “yellow” has no weight in these rules");
    EXPECT_EQ(text.finds[2].points.toStdString(), "× 1");
}

TEST(ScoreText, WhatOthersNamedTurnsNoneOfOurWords) {
    auto profile = rules();
    profile.title = "rules\u202e of 2026\n";
    const auto text = scoreText(profile, score(profile, mission()), {});
    EXPECT_THAT(text.rules.toStdString(), testing::StartsWith("rules\\u202e of 2026\\n · version"));
}

TEST(ScoreText, SaysWhatMoreWouldBringAndHowLongThereIs) {
    const auto profile = rules();
    MissionClock clock;
    clock.left = std::chrono::minutes(12) + std::chrono::seconds(59);
    const auto text = scoreText(profile, score(profile, mission()), clock);
    EXPECT_EQ(text.left.toStdString(), "12 min left");
    ASSERT_THAT(text.advice, SizeIs(2));
    EXPECT_EQ(text.advice[0].what.toStdString(), "V2: confirm");
    EXPECT_EQ(text.advice[0].points.toStdString(), "+2.5");
    EXPECT_EQ(text.advice[1].what.toStdString(), "V1: heat");
    clock.left = std::chrono::seconds(-70);
    EXPECT_EQ(scoreText(profile, score(profile, mission()), clock).left.toStdString(), "time is over");
}

}  // namespace
}  // namespace leitstand
