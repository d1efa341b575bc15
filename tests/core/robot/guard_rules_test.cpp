#include "core/robot/control/stop/guard_rules.h"

#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "core/event/station_samples.h"
#include "tests/core/robot/control_scene.h"

namespace leitstand::test {
namespace {

using Action = GrantSample::Action;
const GuardPulse Driving{.driving = true}, Resting{};

class Guard : public testing::Test {
protected:
    /// When zeros are sent between @p from and @p until, looked at every 5 ms; pulses come as @p reported
    /// says.
    template <class Told>
    std::vector<std::int64_t> zeros(std::int64_t from, std::int64_t until, Told reported) {
        std::vector<std::int64_t> moments;
        for (std::int64_t now = from; now < until; now += 5) {
            reported(now);
            const GuardRules::Step step = m_rules.step(at(now));
            if (step.zero) moments.push_back(now);
            m_over = m_over || step.over;
        }
        return moments;
    }
    std::vector<std::int64_t> zeros(std::int64_t from, std::int64_t until) {
        return zeros(from, until, [](std::int64_t) {});
    }
    GuardRules m_rules{"kurt3d", "a"};
    bool m_over = false;
};

TEST_F(Guard, SaysNothingWhileItsStationSpeaks) {
    EXPECT_TRUE(zeros(0, 20'000, [&](std::int64_t now) {
                    if (now % 195 == 0) m_rules.pulse(Driving, at(now));
                }).empty());
    EXPECT_FALSE(m_over);
}

TEST_F(Guard, ASilentStationThatDroveIsFollowedByZerosForTwoSeconds) {
    m_rules.pulse(Driving, at(0));
    const auto moments = zeros(0, 20'000);
    ASSERT_EQ(moments.size(), 40U);
    EXPECT_EQ(moments.front(), 200);
    EXPECT_LT(moments.back(), 2'200);
    EXPECT_FALSE(m_over) << "the station may be back";
    m_rules.pulse(Driving, at(20'000));
    EXPECT_EQ(zeros(20'000, 30'000).size(), 40U) << "and hang again";
}

TEST_F(Guard, AStationThatDiesIsFollowedAtOnceAndThenItEnds) {
    m_rules.pulse(Driving, at(0));
    m_rules.closed();
    const auto moments = zeros(10, 2'005);
    EXPECT_EQ(moments.front(), 10);
    EXPECT_FALSE(m_over);
    EXPECT_TRUE(zeros(2'010, 5'000).empty());
    EXPECT_TRUE(m_over);
}

TEST_F(Guard, WhereTheStationDidNotDriveNothingIsSent) {
    EXPECT_TRUE(zeros(0, 5'000).empty());
    m_rules.pulse(Driving, at(5'000));
    m_rules.pulse(Resting, at(5'050));
    EXPECT_TRUE(zeros(5'050, 10'000).empty());
    m_rules.closed();
    EXPECT_TRUE(zeros(10'000, 10'010).empty());
    EXPECT_TRUE(m_over);
}

TEST_F(Guard, AStationThatSpeaksAgainHasTheRobotAgain) {
    m_rules.pulse(Driving, at(0));
    EXPECT_FALSE(zeros(0, 1'000).empty());
    EXPECT_TRUE(m_rules.isStopping());
    m_rules.pulse(Driving, at(1'000));
    EXPECT_FALSE(m_rules.isStopping());
    EXPECT_TRUE(zeros(1'000, 1'195).empty());
}

TEST_F(Guard, ItNeverOverridesSomebodyElsesCommands) {
    m_rules.pulse(Driving, at(0));
    m_rules.commanded(at(100));
    EXPECT_TRUE(zeros(0, 1'100).empty());
    EXPECT_FALSE(zeros(1'100, 1'300).empty()) << "the other one stopped before";
    m_rules.commanded(at(1'300));
    EXPECT_TRUE(zeros(1'300, 20'000).empty()) << "in the middle of its zeros";
}

TEST_F(Guard, ItNeverOverridesAnotherStationsGrant) {
    m_rules.receive(grantSaying("a", Action::Hold), sender(1), at(0));
    m_rules.pulse(Driving, at(0));
    EXPECT_FALSE(zeros(0, 400).empty());
    m_rules.receive(grantSaying("a", Action::Consent, 1, "b"), sender(1), at(400));
    m_rules.receive(grantSaying("b", Action::Hold, 2), sender(2), at(405));
    EXPECT_TRUE(zeros(405, 20'000).empty());
}

TEST_F(Guard, OneThatIsAskedLateCatchesUpWithOneZero) {
    m_rules.pulse(Driving, at(0));
    EXPECT_TRUE(m_rules.step(at(900)).zero);
    EXPECT_FALSE(m_rules.step(at(901)).zero);
    EXPECT_EQ(m_rules.step(at(901)).next, at(950));
}

TEST(GuardPulse, IsReadAsItWasWritten) {
    for (const GuardPulse& pulse : {Driving, Resting, GuardPulse{true, std::chrono::nanoseconds::min()},
                                    GuardPulse{false, std::chrono::nanoseconds::max()}}) {
        const auto read = guardPulseFrom(toString(pulse));
        ASSERT_TRUE(read) << toString(pulse);
        EXPECT_EQ(*read, pulse);
    }
}

TEST(GuardPulse, WhatIsNoPulseIsRefused) {
    for (const std::string& text :
         {std::string(), std::string("drive"), std::string("drive "), std::string("drives 0"),
          std::string("rest 1.5"), std::string("rest 0 "), std::string("DRIVE 0"), std::string("drive nan"),
          std::string("drive 9223372036854775808"), std::string("drive -"), std::string(1'000'000, '9'),
          std::string("rest 0\0", 7), "drive " + std::string(1'000'000, '1')}) {
        EXPECT_FALSE(guardPulseFrom(text).ok()) << text.substr(0, 40);
    }
}

}  // namespace
}  // namespace leitstand::test
