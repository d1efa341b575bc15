#include <gtest/gtest.h>

#include "core/event/station_samples.h"
#include "core/robot/control/grant_arbiter.h"
#include "tests/core/robot/control_scene.h"

namespace leitstand::test {
namespace {

using Action = GrantSample::Action;

class Arbiter : public testing::Test {
protected:
    void says(const std::string& station, std::uint8_t process, Action action, std::int64_t now,
              const std::string& other = {}, std::uint64_t term = 1) {
        m_arbiter.receive(grantSaying(station, action, term, other), sender(process), at(now));
    }
    [[nodiscard]] bool obeys(std::uint8_t process, std::int64_t now) const {
        return m_arbiter.obeys(sender(process), at(now));
    }
    GrantArbiter m_arbiter{Drive};
};

TEST_F(Arbiter, ObeysTheFirstThatSaysSo) {
    EXPECT_FALSE(obeys(1, 0));
    EXPECT_EQ(m_arbiter.holder(at(0)), "");
    says("a", 1, Action::Hold, 0);
    EXPECT_TRUE(obeys(1, 0));
    EXPECT_FALSE(obeys(2, 0));
    EXPECT_EQ(m_arbiter.holder(at(0)), "a");
    says("b", 2, Action::Hold, 100, {}, 1'000);
    EXPECT_FALSE(obeys(2, 100)) << "no term takes it from who holds it";
}

TEST_F(Arbiter, ASilentHolderIsObeyedNoLongerAndGivesWay) {
    says("a", 1, Action::Hold, 0);
    says("b", 2, Action::Hold, 2'999);
    EXPECT_FALSE(obeys(2, 2'999));
    EXPECT_TRUE(obeys(1, 2'999));
    EXPECT_FALSE(obeys(1, 3'000));
    EXPECT_FALSE(obeys(2, 3'000)) << "it has to say so again";
    says("b", 2, Action::Hold, 3'500);
    EXPECT_TRUE(obeys(2, 3'500));
    says("a", 1, Action::Hold, 3'600);
    EXPECT_FALSE(obeys(1, 3'600));
}

TEST_F(Arbiter, ASilentHolderThatComesBackFirstIsObeyedAgain) {
    says("a", 1, Action::Hold, 0);
    const auto changes = m_arbiter.changes();
    says("a", 1, Action::Hold, 60'000);
    EXPECT_TRUE(obeys(1, 60'000));
    EXPECT_EQ(m_arbiter.changes(), changes);
}

TEST_F(Arbiter, FollowsAConsentAndNobodyElseMeanwhile) {
    says("a", 1, Action::Hold, 0);
    says("a", 1, Action::Consent, 100, "b");
    EXPECT_FALSE(obeys(1, 100));
    says("c", 3, Action::Hold, 110);
    EXPECT_FALSE(obeys(3, 110));
    says("b", 2, Action::Hold, 120);
    EXPECT_TRUE(obeys(2, 120));
}

TEST_F(Arbiter, AConsentNobodyTakesUpLapses) {
    says("a", 1, Action::Hold, 0);
    says("a", 1, Action::Consent, 100, "b");
    says("c", 3, Action::Hold, 3'099);
    EXPECT_FALSE(obeys(3, 3'099));
    says("c", 3, Action::Hold, 3'100);
    EXPECT_TRUE(obeys(3, 3'100));
}

TEST_F(Arbiter, AHeartbeatThatOvertookTheConsentCounts) {
    says("a", 1, Action::Hold, 0);
    says("b", 2, Action::Hold, 90);
    EXPECT_FALSE(obeys(2, 90));
    says("a", 1, Action::Consent, 100, "b");
    EXPECT_TRUE(obeys(2, 100));
}

TEST_F(Arbiter, OnlyTheHoldersProcessGivesItUp) {
    says("a", 1, Action::Hold, 0);
    says("a", 9, Action::Release, 10);  // somebody who says that he is a
    says("b", 2, Action::Consent, 10, "b");
    EXPECT_TRUE(obeys(1, 10));
    says("a", 1, Action::Release, 20);
    EXPECT_FALSE(obeys(1, 20));
    says("b", 2, Action::Hold, 30);
    EXPECT_TRUE(obeys(2, 30));
}

TEST_F(Arbiter, ARestartedStationIsObeyedAtOnceAndItsEarlierProcessNoMore) {
    says("a", 1, Action::Hold, 0);
    const auto changes = m_arbiter.changes();
    says("a", 2, Action::Hold, 500);
    EXPECT_TRUE(obeys(2, 500));
    EXPECT_FALSE(obeys(1, 500));
    EXPECT_GT(m_arbiter.changes(), changes);
    // Both run: the robot must not be driven by turns.
    for (std::int64_t now = 600; now < 10'000; now += 1'000) {
        says("a", 1, Action::Hold, now);
        says("a", 2, Action::Hold, now + 10);
        EXPECT_TRUE(obeys(2, now + 20));
        EXPECT_FALSE(obeys(1, now + 20));
    }
}

TEST_F(Arbiter, OtherGrantsAndQuestionsAreNoneOfItsBusiness) {
    GrantSample camera = grantSaying("a", Action::Hold);
    camera.kind = GrantSample::Kind::Camera;
    m_arbiter.receive(camera, sender(1), at(0));
    GrantSample crawler = grantSaying("a", Action::Hold);
    crawler.robot = "crawler";
    m_arbiter.receive(crawler, sender(1), at(0));
    says("a", 1, Action::Request, 0);
    says("a", 1, Action::Refuse, 0, "b");
    EXPECT_FALSE(obeys(1, 0));
}

}  // namespace
}  // namespace leitstand::test
