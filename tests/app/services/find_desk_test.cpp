#include "app/services/finds/find_desk.h"

#include <chrono>
#include <cstdio>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/event/find_sample.h"
#include "core/perception/pictures/coding/picture_encoding.h"
#include "tests/app/services/find_desk_fixture.h"

namespace leitstand::test {
namespace {

using Kind = FindSample::Kind;
using Status = FindSample::Status;
using testing::HasSubstr;
using testing::SizeIs;

/// What studies of operators ask for: filed in ten seconds, or driven past. Two presses, and at worst nobody
/// knows where.
TEST_F(FindDeskTest, LatencyFromTheKeyToAConfirmedVictimIsFarBelowTenSeconds) {
    for (const bool answers : {true, false}) {
        m_answers = answers;
        m_desk->onEvent(m_robot.info());
        for (int i = 0; i < 45; ++i) {  // three seconds of a camera and of an infrared one
            m_desk->onEvent(m_robot.picture(at(7.1 + i / 15.0), 2 + i % 14));
            m_desk->onEvent(m_robot.infrared(at(7.1 + i / 15.0), 30, 34.0));
        }
        if (!answers) m_base = Pose(Eigen::Translation3d(5.0, 0.0, 0.0));
        const auto pressed = std::chrono::steady_clock::now();
        m_desk->freeze("kurt3d", Kind::Victim, "left");
        ASSERT_TRUE(m_desk->confirmNewest()) << "the second press need not wait";
        m_desk->finish();
        const std::chrono::duration<double> took = std::chrono::steady_clock::now() - pressed;
        std::printf("filed and confirmed %.2f s after the key\n", took.count());
        EXPECT_LT(took.count(), answers ? 2.0 : 5.0);
        EXPECT_EQ(find(answers ? 1 : 2).status, Status::Confirmed);
    }
}

TEST_F(FindDeskTest, NobodyIsAskedToConfirmWhatIsConfirmedAlready) {
    const auto filedAndTold = [&] {
        m_desk->freezeAt("kurt3d", Kind::Victim, {2.0, 0.0, 0.2});
        m_desk->finish();
        return m_reported.back();
    };
    EXPECT_THAT(filedAndTold(), testing::HasSubstr("press again"));
    EXPECT_THAT(filedAndTold(), testing::HasSubstr("press again")) << "more of it, not confirmed yet";
    ASSERT_TRUE(m_desk->confirmNewest());
    EXPECT_THAT(filedAndTold(), testing::HasSubstr("V1 has new evidence; it is confirmed already"));
    EXPECT_FALSE(m_desk->confirmNewest());
}

TEST_F(FindDeskTest, WhatIsPointedToIsLookedForInThePictureThatWasPointedInto) {
    m_desk->onEvent(m_robot.info());
    m_desk->onEvent(m_robot.picture(at(8.5), 2));  // sharper, but the robot moved on
    const Event pointed = m_robot.picture(at(9.5), 14);
    m_desk->onEvent(pointed);
    m_desk->onEvent(m_robot.picture(at(9.9), 12));
    m_desk->freeze("kurt3d", Kind::Victim, "right", PicturePoint{"left", {0.25, 0.75}, pointed.sequence});
    finish();
    ASSERT_THAT(*m_state.finds, SizeIs(1));
    EXPECT_EQ(find(1).evidence.at(0).sequence, pointed.sequence);
    ASSERT_TRUE(m_asked && m_asked->picture);
    EXPECT_EQ(m_asked->picture->sequence, pointed.sequence);
    EXPECT_EQ(m_asked->pixel, Eigen::Vector2d(16.0, 36.0));
}

TEST_F(FindDeskTest, TheInfraredPictureThatWasPointedIntoIsTheEvidence) {
    m_desk->onEvent(m_robot.info());
    m_desk->onEvent(m_robot.info("ir"));
    m_desk->onEvent(m_robot.picture(at(9.0), 2));
    const Event pointed = m_robot.infrared(at(9.2), 16, 31.0);
    m_desk->onEvent(pointed);
    m_desk->onEvent(m_robot.infrared(at(9.6), 48, 36.0));  // another body came into sight
    m_desk->freeze("kurt3d", Kind::Victim, "left", PicturePoint{"ir", {0.25, 0.5}, pointed.sequence});
    finish();
    ASSERT_THAT(*m_state.finds, SizeIs(1));
    std::vector<std::uint64_t> kept;
    for (const VictimEvidence& one : find(1).evidence) {
        if (one.kind == "thermal") kept.push_back(one.sequence);
    }
    EXPECT_THAT(kept, testing::ElementsAre(pointed.sequence)) << "that one, and nothing twice";
    EXPECT_NEAR(find(1).heat.value, 31.0, 0.1) << "of what was pointed to";
    ASSERT_TRUE(m_asked && m_asked->picture);
    EXPECT_EQ(m_asked->picture->sequence, pointed.sequence);
    EXPECT_EQ(m_asked->pixel, Eigen::Vector2d(16.0, 24.0));
}

TEST_F(FindDeskTest, PointingIntoAPictureThatIsGoneStillFiles) {
    m_place.reset();
    m_desk->onEvent(m_robot.info("ir"));
    m_desk->onEvent(m_robot.infrared(at(9.6), 48, 36.0));
    m_desk->freeze("kurt3d", Kind::Victim, "left", PicturePoint{"ir", {0.25, 0.5}, 7});
    finish();
    ASSERT_THAT(*m_state.finds, SizeIs(1));
    EXPECT_FALSE(m_asked) << "a pixel of a picture that is gone says nothing about another one";
    EXPECT_EQ(find(1).evidence.size(), 1U) << "what there is is kept";
    EXPECT_THAT(m_reported, testing::Contains(HasSubstr("no range there")));
}

TEST_F(FindDeskTest, PointingWithoutAnyPictureFilesWithoutEvidence) {
    m_place.reset();
    m_desk->freeze("kurt3d", Kind::Victim, "left", PicturePoint{"ir", {0.25, 0.5}, 7});
    finish();
    ASSERT_THAT(*m_state.finds, SizeIs(1));
    EXPECT_TRUE(find(1).evidence.empty());
    EXPECT_EQ(find(1).positionInMap.x(), 1.0) << "ahead of the robot";
}

TEST_F(FindDeskTest, TheSharpestPictureOfTheLastSecondsIsFrozen) {
    m_desk->onEvent(m_robot.info());
    m_desk->onEvent(m_robot.picture(at(1.0), 1));  // sharp, but long ago
    m_desk->onEvent(m_robot.picture(at(8.0), 16));
    const Event sharp = m_robot.picture(at(8.5), 2);
    m_desk->onEvent(sharp);
    m_desk->onEvent(m_robot.picture(at(9.9), 14));
    m_desk->freeze("kurt3d", Kind::Victim, "left");
    finish();
    ASSERT_THAT(*m_state.finds, SizeIs(1));
    ASSERT_THAT(find(1).evidence, SizeIs(1));
    EXPECT_EQ(find(1).evidence[0].sequence, sharp.sequence);
    EXPECT_EQ(find(1).positionInMap, Eigen::Vector3d(2.0, 1.0, 0.4));
    EXPECT_EQ(find(1).found, at(10.0));
    EXPECT_EQ(m_asked->pixel, Eigen::Vector2d(32.0, 24.0)) << "the middle of the picture that is looked at";
}

TEST_F(FindDeskTest, WhereTheOperatorPointsToCounts) {
    m_desk->onEvent(m_robot.info());
    m_desk->onEvent(m_robot.picture(at(9.0), 2));
    m_desk->freeze("kurt3d", Kind::Hazard, "left", PicturePoint{"left", {0.25, 0.75}});
    finish();
    EXPECT_EQ(m_asked->pixel, Eigen::Vector2d(16.0, 36.0));
    EXPECT_EQ(find(1, Kind::Hazard).kind, Kind::Hazard);
}

TEST_F(FindDeskTest, OnlyAVictimIsLookedForWhereItIsWarm) {
    m_desk->onEvent(m_robot.info());
    m_desk->onEvent(m_robot.info("ir"));
    const Event picture = m_robot.picture(at(9.0), 2), infrared = m_robot.infrared(at(9.6), 48, 36.0);
    m_desk->onEvent(picture);
    m_desk->onEvent(infrared);
    for (const Kind kind : {Kind::Hazard, Kind::Code, Kind::Object}) {
        m_asked.reset();
        m_desk->freeze("kurt3d", kind, "left");
        m_desk->finish();
        ASSERT_TRUE(m_asked && m_asked->picture) << nameOf(kind, 1);
        EXPECT_EQ(m_asked->picture->sequence, picture.sequence) << nameOf(kind, 1) << ": a body is beside it";
        EXPECT_EQ(m_asked->pixel, Eigen::Vector2d(32.0, 24.0)) << nameOf(kind, 1) << ": the crosshair";
    }
    m_desk->freeze("kurt3d", Kind::Victim, "left");
    finish();
    EXPECT_EQ(m_asked->picture->sequence, infrared.sequence);
    EXPECT_NEAR(m_asked->pixel.x(), 48.0, 1.0) << "the body";
    EXPECT_NEAR(find(1).heat.value, 36.0, 0.1);
}

TEST_F(FindDeskTest, ASignIsLookedForInTheMiddleOfTheInfraredPictureThatIsLookedAt) {
    m_desk->onEvent(m_robot.info("ir"));
    m_desk->onEvent(m_robot.infrared(at(9.6), 48, 36.0));
    m_desk->freeze("kurt3d", Kind::Hazard, "ir");
    finish();
    ASSERT_TRUE(m_asked && m_asked->picture);
    EXPECT_EQ(m_asked->pixel, Eigen::Vector2d(32.0, 24.0)) << "not at the body in it";
}

TEST_F(FindDeskTest, GasCountsWhereItRose) {
    m_desk->onEvent(m_robot.gas(at(1.0), 420.0));
    m_desk->onEvent(m_robot.gas(at(9.0), 1'800.0));
    m_desk->freeze("kurt3d", Kind::Victim, "left");
    finish();
    EXPECT_EQ(find(1).co2.value, 1'800.0);
    EXPECT_EQ(find(1).heat.state, VictimSign::State::Unknown) << "nothing warm was seen";
}

TEST_F(FindDeskTest, TheGasOfTheLastMinuteIsFrozenAsATrace) {
    std::vector<std::uint64_t> readings;
    for (int i = 0; i < 1'000; ++i) {  // ten a second, for 100 s
        const Event reading = m_robot.gas(at(0.1 * i), i == 995 ? 2'000.0 : 400.0 + i);
        readings.push_back(reading.sequence);
        m_desk->onEvent(reading);
    }
    m_desk->freeze("kurt3d", Kind::Victim, "left");
    finish();
    std::vector<std::uint64_t> frozen;
    for (const VictimEvidence& one : find(1).evidence) {
        EXPECT_EQ(one.kind, "gas");
        frozen.push_back(one.sequence);
    }
    EXPECT_GE(frozen.size(), 55U);
    EXPECT_LE(frozen.size(), 63U) << "one a second is enough to draw it";
    EXPECT_GE(frozen.front(), readings[395]) << "of the last minute";
    EXPECT_THAT(frozen, testing::Contains(readings[995])) << "a peak is not thinned away";
    EXPECT_EQ(frozen.back(), readings.back());
    EXPECT_TRUE(std::is_sorted(frozen.begin(), frozen.end()));
    EXPECT_EQ(find(1).co2.value, 1'399.0);
}

TEST_F(FindDeskTest, ASecondFindOfTheSameMinuteNamesTheSameReadings) {
    for (int i = 0; i < 300; ++i) m_desk->onEvent(m_robot.gas(at(0.2 * i), 400.0 + i % 7));
    m_desk->freeze("kurt3d", Kind::Victim, "left");
    m_desk->freeze("kurt3d", Kind::Victim, "left");
    finish();
    ASSERT_THAT(*m_state.finds, SizeIs(1)) << "it joins the first";
    EXPECT_LE(find(1).evidence.size(), 63U);
}

TEST_F(FindDeskTest, WithoutARangeItIsFiledAheadOfTheRobotAndSaid) {
    m_place.reset();
    m_desk->onEvent(m_robot.info());
    m_desk->onEvent(m_robot.picture(at(9.0), 2));
    m_desk->freeze("kurt3d", Kind::Victim, "left");
    finish();
    EXPECT_EQ(find(1).positionInMap.x(), 1.0);
    EXPECT_GE(find(1).deviation, 0.5);
    EXPECT_THAT(m_reported, testing::Contains(HasSubstr("no range there")));
}

TEST_F(FindDeskTest, ARobotThatIsNotInTheMapSaysSo) {
    m_base.reset();
    m_place.reset();
    m_desk->freeze("kurt3d", Kind::Victim, "left");
    finish();
    EXPECT_THAT(*m_state.finds, SizeIs(0));
    EXPECT_THAT(m_reported, testing::Contains(HasSubstr("Kurt3D is not in the map yet")));
}

TEST_F(FindDeskTest, TheSecondPressConfirmsAndUndoTakesItBack) {
    m_desk->onEvent(m_robot.info());
    m_desk->freezeAt("kurt3d", Kind::Victim, {3.0, 0.0, 0.2});
    while (!m_desk->newest()) std::this_thread::yield();
    const FindKey key = *m_desk->newest();
    ASSERT_TRUE(m_desk->confirm(key));
    EXPECT_EQ(find(1).status, Status::Confirmed);
    ASSERT_TRUE(m_desk->undo());
    EXPECT_EQ(find(1).status, Status::Hypothesis);
    ASSERT_TRUE(m_desk->undo());
    EXPECT_THAT(*m_state.finds, SizeIs(0));
    EXPECT_THAT(m_desk->undo().error().text, HasSubstr("nothing on finds"));
    EXPECT_FALSE(m_desk->confirm(key));
    EXPECT_FALSE(m_desk->fileCandidate(9));
}

TEST_F(FindDeskTest, ASecondPressWhileItsPlaceIsSearchedConfirmsItAsSoonAsItIsFiled) {
    std::promise<void> searched;
    m_search = searched.get_future().share();
    m_desk->onEvent(m_robot.info());
    m_desk->onEvent(m_robot.picture(at(9.0), 2));
    m_desk->freeze("kurt3d", Kind::Victim, "left");
    EXPECT_TRUE(m_desk->isFiling());
    EXPECT_TRUE(m_desk->confirmNewest());
    searched.set_value();
    m_desk->finish();
    EXPECT_EQ(find(1).status, Status::Confirmed);
    EXPECT_FALSE(m_desk->isFiling());
    EXPECT_THAT(m_desk->confirmNewest().error().text, HasSubstr("Nothing is filed"));
}

TEST_F(FindDeskTest, WhereNothingCameOfTheLastPressNoOlderFindIsConfirmed) {
    m_desk->onEvent(m_robot.info());
    m_desk->onEvent(m_robot.picture(at(9.0), 2));
    m_desk->freeze("kurt3d", Kind::Victim, "left");
    m_desk->finish();
    std::promise<void> searched;
    m_search = searched.get_future().share();
    m_place.reset();
    m_base.reset();  // it is not in the map any more
    m_desk->freeze("kurt3d", Kind::Victim, "left");
    EXPECT_TRUE(m_desk->confirmNewest());
    searched.set_value();
    m_desk->finish();
    ASSERT_THAT(*m_state.finds, SizeIs(1));
    EXPECT_EQ(find(1).status, Status::Hypothesis);
    EXPECT_EQ(m_desk->unconfirmed(), FindKey(Kind::Victim, 1)) << "it waits as before";
    EXPECT_TRUE(m_desk->confirmNewest());
    EXPECT_EQ(find(1).status, Status::Confirmed);
}

}  // namespace
}  // namespace leitstand::test
