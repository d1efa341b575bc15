// What a robot said long ago is no evidence of what the operator sees now. The desk's clock says 10 s.
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/event/cloud_sample.h"
#include "core/event/find_sample.h"
#include "core/event/motion_samples.h"
#include "core/event/stream_role.h"
#include "tests/app/services/find_desk_fixture.h"

namespace leitstand::test {
namespace {

using Kind = FindSample::Kind;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// A robot with everything that can be evidence.
class FindFreshness : public FindDeskTest {
protected:
    [[nodiscard]] Event scan(Time when) {
        return m_robot.event(when, StreamRole::Points, "scanner", CloudSample());
    }
    [[nodiscard]] Event odometry(Time when) {
        return m_robot.event(when, StreamRole::Odometry, "odom", OdometrySample());
    }
    [[nodiscard]] std::vector<std::string> kinds() {
        std::vector<std::string> all;
        for (const VictimEvidence& one : find(1).evidence) all.push_back(one.kind);
        return all;
    }
    void calibrated() {
        m_desk->onEvent(m_robot.info());
        m_desk->onEvent(m_robot.info("ir"));
    }
};

TEST_F(FindFreshness, ARobotThatFellSilentShowsNothing) {
    calibrated();
    m_desk->onEvent(m_robot.picture(at(-60.0), 2));
    m_desk->onEvent(m_robot.infrared(at(-60.0), 48, 36.0));
    m_desk->onEvent(m_robot.gas(at(-80.0), 420.0));
    m_desk->onEvent(m_robot.gas(at(-60.0), 1'800.0));
    m_desk->onEvent(scan(at(-60.0)));
    m_desk->onEvent(odometry(at(-60.0)));
    m_desk->freeze("kurt3d", Kind::Victim, "left");
    finish();
    ASSERT_THAT(*m_state.finds, SizeIs(1));
    EXPECT_THAT(find(1).evidence, IsEmpty());
    EXPECT_EQ(find(1).heat.state, VictimSign::State::Unknown) << "of a minute ago";
    EXPECT_EQ(find(1).co2.state, VictimSign::State::Unknown);
    EXPECT_FALSE(m_asked) << "nothing is looked for through an old picture";
    EXPECT_EQ(find(1).positionInMap.x(), 1.0) << "ahead of the robot";
    EXPECT_THAT(m_reported, testing::Contains(HasSubstr("no range there")));
}

TEST_F(FindFreshness, ACameraThatStoppedIsLeftOutAndTheOthersCount) {
    calibrated();
    const Event picture = m_robot.picture(at(9.8), 2);
    m_desk->onEvent(m_robot.infrared(at(5.0), 48, 36.0));
    m_desk->onEvent(picture);
    m_desk->onEvent(m_robot.gas(at(9.0), 450.0));
    m_desk->onEvent(odometry(at(9.9)));
    m_desk->freeze("kurt3d", Kind::Victim, "left");
    finish();
    EXPECT_THAT(kinds(), ElementsAre("picture", "gas", "odometry"));
    EXPECT_EQ(find(1).heat.state, VictimSign::State::Unknown);
    ASSERT_TRUE(m_asked && m_asked->picture);
    EXPECT_EQ(m_asked->picture->sequence, picture.sequence) << "not where it was warm";
}

TEST_F(FindFreshness, AnInfraredPictureOfASecondAgoCounts) {
    calibrated();
    const Event infrared = m_robot.infrared(at(9.0), 48, 36.0);
    m_desk->onEvent(infrared);
    m_desk->freeze("kurt3d", Kind::Victim, "left");
    finish();
    EXPECT_EQ(find(1).heat.state, VictimSign::State::Present);
    ASSERT_TRUE(m_asked && m_asked->picture);
    EXPECT_EQ(m_asked->picture->sequence, infrared.sequence);
}

TEST_F(FindFreshness, TheGasThatStoppedIsNoTrace) {
    m_desk->onEvent(m_robot.gas(at(-40.0), 420.0));
    m_desk->onEvent(m_robot.gas(at(-1.0), 1'800.0));  // and nothing for 11 s
    m_desk->freeze("kurt3d", Kind::Victim, "left");
    finish();
    EXPECT_THAT(find(1).evidence, IsEmpty());
    EXPECT_EQ(find(1).co2.state, VictimSign::State::Unknown);
}

TEST_F(FindFreshness, TheGasTraceGoesBackAMinuteFromNow) {
    m_desk->onEvent(m_robot.gas(at(-52.0), 420.0));  // within a minute of the newest reading, not of now
    m_desk->onEvent(m_robot.gas(at(5.0), 600.0));
    m_desk->freeze("kurt3d", Kind::Victim, "left");
    finish();
    EXPECT_THAT(find(1).evidence, SizeIs(1));
    EXPECT_EQ(find(1).co2.state, VictimSign::State::Unknown) << "nothing says that it rose";
}

TEST_F(FindFreshness, ThePictureThatAPersonPointsIntoCountsHoweverOldItIs) {
    calibrated();
    const Event pointed = m_robot.picture(at(2.0), 12);
    m_desk->onEvent(pointed);
    m_desk->onEvent(m_robot.picture(at(2.5), 2));  // old as well, and nobody pointed to it
    m_desk->freeze("kurt3d", Kind::Victim, {}, PicturePoint{"left", {0.25, 0.75}, pointed.sequence});
    finish();
    ASSERT_THAT(find(1).evidence, SizeIs(1));
    EXPECT_EQ(find(1).evidence[0].sequence, pointed.sequence) << "a thin link brings one in many seconds";
    ASSERT_TRUE(m_asked && m_asked->picture);
    EXPECT_EQ(m_asked->pixel, Eigen::Vector2d(16.0, 36.0));
}

TEST_F(FindFreshness, AClockThatWasSetBackTakesNothingAway) {
    calibrated();
    m_desk->onEvent(m_robot.picture(at(600.0), 2));
    m_desk->onEvent(m_robot.gas(at(600.0), 450.0));
    m_desk->freeze("kurt3d", Kind::Victim, "left");
    finish();
    EXPECT_THAT(kinds(), ElementsAre("picture", "gas"));
}

}  // namespace
}  // namespace leitstand::test
