#include "app/services/finds/find_desk.h"

#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/event/status_samples.h"
#include "core/event/stream_role.h"
#include "core/mission/finds/dismissal.h"
#include "tests/app/services/find_desk_fixture.h"

namespace leitstand::test {
namespace {

using Kind = FindSample::Kind;
using testing::HasSubstr;
using testing::SizeIs;

TEST_F(FindDeskTest, ACandidateIsFiledWithItsCuesAndWithWhatItsRobotSeesThere) {
    believe();
    m_desk->onEvent(m_robot.picture(at(8.5), 16));
    const Event sharp = m_robot.picture(at(9.0), 2), gas = m_robot.gas(at(9.5), 450.0);
    m_desk->onEvent(sharp);
    m_desk->onEvent(gas);
    ASSERT_TRUE(m_desk->fileCandidate(7));
    finish();
    ASSERT_THAT(*m_state.finds, SizeIs(1));
    EXPECT_THAT(evidenceOf(find(1)), testing::UnorderedElementsAre(12, 13, sharp.sequence, gas.sequence));
    EXPECT_EQ(m_lookedAt, Eigen::Vector3d(2.0, 1.0, 0.4));
    EXPECT_EQ(find(1).positionInMap, Eigen::Vector3d(2.0, 1.0, 0.4)) << "where the station has it";
    EXPECT_EQ(find(1).heat.value, 33.5);
    EXPECT_EQ(find(1).robot, "kurt3d");
    EXPECT_EQ(candidate().victim, 1U) << "it is shown once";
    EXPECT_THAT(m_reported, testing::Contains(HasSubstr("V1 filed")));
}

TEST_F(FindDeskTest, AFindIsAutonomousWhenTheRobotDroveItselfAsItWasTold) {
    const auto drives = [&](double when, bool autonomous) {
        ModeSample mode;
        mode.autonomous = autonomous;
        const Event event = m_robot.event(at(when), StreamRole::Mode, "mode", mode);
        m_state = fold(std::move(m_state), event);
        m_desk->onEvent(event);
    };
    drives(3.0, true);
    believe();
    drives(8.0, false);
    believe(0.9);
    ASSERT_TRUE(m_desk->fileCandidate(7));
    m_desk->finish();
    EXPECT_TRUE(find(1).autonomous) << "the operator took over to look at it";
    m_desk->freezeAt("kurt3d", Kind::Victim, {8.0, 0.0, 0.2});
    finish();
    EXPECT_FALSE(find(2).autonomous);
}

TEST_F(FindDeskTest, ASecondPressWhileWhatItsRobotSeesIsLookedAtConfirmsTheCandidate) {
    believe();
    m_desk->onEvent(m_robot.picture(at(9.0), 2));
    ASSERT_TRUE(m_desk->fileCandidate(7));
    EXPECT_TRUE(m_desk->isFiling() || m_desk->unconfirmed()) << "the next press is about it";
    ASSERT_TRUE(m_desk->confirmNewest());
    finish();
    ASSERT_THAT(*m_state.finds, SizeIs(1));
    EXPECT_EQ(find(1).status, FindSample::Status::Confirmed);
}

TEST_F(FindDeskTest, WhatLooksElsewhereOrIsOldIsNoEvidenceOfACandidate) {
    believe();
    m_looksThere = false;
    m_desk->onEvent(m_robot.picture(at(9.0), 2));
    m_desk->onEvent(m_robot.gas(at(9.5), 450.0));
    ASSERT_TRUE(m_desk->fileCandidate(7));
    m_desk->finish();
    EXPECT_THAT(evidenceOf(find(1)), testing::UnorderedElementsAre(12, 13)) << "its cues alone";
    ASSERT_TRUE(m_desk->undo());
    EXPECT_THAT(*m_state.finds, SizeIs(0));
    EXPECT_FALSE(isFiled(m_state, candidate())) << "it stands again";
}

TEST_F(FindDeskTest, PicturesOfLongAgoAreNoEvidenceOfACandidate) {
    believe();
    m_desk->onEvent(m_robot.picture(at(3.0), 2));  // the robot has been silent since
    ASSERT_TRUE(m_desk->fileCandidate(7));
    finish();
    EXPECT_THAT(evidenceOf(find(1)), testing::UnorderedElementsAre(12, 13));
    EXPECT_FALSE(m_lookedAt) << "nobody is asked about nothing";
}

TEST_F(FindDeskTest, WhatIsFrozenBesideACandidateTakesItsCues) {
    believe();
    const Event picture = m_robot.picture(at(9.0), 2);
    m_desk->onEvent(m_robot.info());
    m_desk->onEvent(picture);
    m_place = PlacedFind{0, {2.3, 1.2, 0.4}, 0.1};
    m_desk->freeze("kurt3d", Kind::Victim, "left");
    m_desk->finish();
    EXPECT_THAT(evidenceOf(find(1)), testing::UnorderedElementsAre(12, 13, picture.sequence));
    EXPECT_EQ(find(1).heat.value, 33.5);
    EXPECT_EQ(find(1).motion.state, VictimSign::State::Present);
    EXPECT_EQ(find(1).positionInMap.x(), 2.3) << "where the operator saw it";
    EXPECT_EQ(candidate().victim, 1U);
    m_place = PlacedFind{0, {6.0, 1.0, 0.4}, 0.1};
    m_desk->freeze("kurt3d", Kind::Victim, "left");
    finish();
    EXPECT_THAT(evidenceOf(find(2)), testing::ElementsAre(picture.sequence)) << "that is elsewhere";
}

TEST_F(FindDeskTest, ADismissedCandidateIsSaidSoAndUndoBringsItBack) {
    believe(0.52);
    m_desk->freezeAt("kurt3d", Kind::Victim, {8.0, 0.0, 0.2});
    m_desk->finish();
    ASSERT_TRUE(m_desk->dismiss(7));
    EXPECT_TRUE(candidate().dismissed);
    EXPECT_TRUE(isDismissal(candidate())) << "by a person, though it is not very sure";
    ASSERT_TRUE(m_desk->undo());
    EXPECT_FALSE(candidate().dismissed) << "the newest act first";
    EXPECT_THAT(*m_state.finds, SizeIs(1));
    ASSERT_TRUE(m_desk->undo());
    EXPECT_THAT(*m_state.finds, SizeIs(0));
    EXPECT_FALSE(m_desk->undo());
    EXPECT_FALSE(m_desk->dismiss(9));
}

TEST_F(FindDeskTest, AnActThatIsNewerThanADismissalIsTakenBackBeforeIt) {
    believe();
    ASSERT_TRUE(m_desk->dismiss(7));
    m_desk->freezeAt("kurt3d", Kind::Victim, {8.0, 0.0, 0.2});
    m_desk->finish();
    ASSERT_TRUE(m_desk->undo());
    EXPECT_THAT(*m_state.finds, SizeIs(0));
    EXPECT_TRUE(candidate().dismissed);
    ASSERT_TRUE(m_desk->undo());
    EXPECT_FALSE(candidate().dismissed);
}

}  // namespace
}  // namespace leitstand::test
