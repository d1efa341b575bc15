#include "tests/app/services/shared_intake_fixture.h"

namespace leitstand::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using SharedFinds = SharedIntakeTest;

TEST_F(SharedFinds, TheNewestFormOfAFindAndTheNewestClockCount) {
    begin();
    VictimSample victim;
    victim.stamp = at(80);
    victim.number = 1;
    hear(victim, station_topic::Victims);
    hear(victim, station_topic::Victims, Third);
    victim.stamp = at(79);
    hear(victim, station_topic::Victims);
    EXPECT_THAT(entered(), ElementsAre("victim"));
    victim.stamp = at(81);
    hear(victim, station_topic::Victims, Third);
    ClockSample clock;
    clock.stamp = at(10);
    hear(clock, station_topic::Clock);
    clock.stamp = at(9);
    hear(clock, station_topic::Clock);
    EXPECT_THAT(entered(), ElementsAre("victim", "clock"));
}

TEST_F(SharedFinds, AFindThatAnotherStationChangedKeepsWhereItsEvidenceStandsInThisLog) {
    begin();
    VictimSample ours;
    ours.stamp = at(80);
    ours.number = 1;
    ours.evidence = {{"picture", "/kurt3d/left", 512, at(79)}, {"gas", "/kurt3d/co2", 513, at(78)}};
    hear(ours, station_topic::Victims);
    VictimSample changed = std::get<VictimSample>(forOthers(ours));
    EXPECT_EQ(changed.evidence[0].sequence, 0u);
    changed.stamp = at(90);
    changed.status = VictimSample::Status::Confirmed;
    changed.evidence.push_back({"picture", "/crawler/left", 0, at(89)});
    hear(changed, station_topic::Victims, Third);
    const VictimSample& kept = m_state->victims->at({VictimSample::Kind::Victim, 1}).victim;
    EXPECT_EQ(kept.status, VictimSample::Status::Confirmed);
    ASSERT_EQ(kept.evidence.size(), 3u);
    EXPECT_EQ(kept.evidence[0].sequence, 512u);
    EXPECT_EQ(kept.evidence[1].sequence, 513u);
    EXPECT_EQ(kept.evidence[2].sequence, 0u) << "another log has it";
}

TEST_F(SharedFinds, OfTwoFindsOfOneNumberTheFirstKeepsItAndTheOtherIsFiledAgain) {
    begin();
    const auto number3 = [&] { return m_state->victims->at({VictimSample::Kind::Victim, 3}).victim; };
    hear(victimFound(50, 50, "us"), station_topic::Victims);  // as this station filed it, unheard
    hear(victimFound(40, 40, "other"), station_topic::Victims);
    EXPECT_EQ(number3().found, at(40));
    ASSERT_EQ(m_filedAgain.size(), 1u);
    EXPECT_EQ(m_filedAgain.front().found, at(50));
    hear(victimFound(60, 90, "third"), station_topic::Victims, Third);  // who filed that does the same
    EXPECT_EQ(number3().found, at(40));
    hear(victimFound(40, 41, "third"), station_topic::Victims, Third);
    EXPECT_EQ(number3().station, "third");
    EXPECT_EQ(m_filedAgain.size(), 1u);
}

TEST_F(SharedFinds, AClockThatBeganByItselfGivesWay) {
    begin();
    ClockSample ours;
    ours.stamp = at(50);
    ours.station = "us";
    ours.running = true;
    hear(ours, station_topic::Clock);
    ClockSample set = ours;
    set.station = "other";
    set.stamp = at(10);  // long before this station came
    set.limit = std::chrono::minutes(20);
    hear(set, station_topic::Clock);
    EXPECT_EQ(m_state->clock->sample.limit, std::chrono::minutes(20));
    ClockSample began = ours;
    began.station = "third";
    began.stamp = at(9);
    hear(began, station_topic::Clock, Third);
    EXPECT_EQ(m_state->clock->sample.station, "other") << "an operator set that";
}

TEST_F(SharedFinds, FindsOfAMapThatNobodyKnowsYetWaitUntilItIsKnown) {
    begin();
    hear(keyScan(1));
    EXPECT_EQ(m_joined, 1);
    EXPECT_TRUE(m_intake->sharesMap());
    begin();  // after a restart
    EXPECT_FALSE(m_intake->sharesMap()) << "nobody confirmed it yet";
    (void)entered();
    GrantSample grant;
    grant.kind = GrantSample::Kind::Map;
    grant.station = "third";
    hear(grant, station_topic::Grants, Third);
    hear(victimFound(40, 40, "third"), station_topic::Victims, Third);
    EXPECT_THAT(entered(), IsEmpty());
    hear(keyScan(1), Third);
    EXPECT_THAT(entered(), ElementsAre("victim"));
    begin();
    hear(grant, station_topic::Grants, Third);
    hear(victimFound(30, 30, "third"), station_topic::Victims, Third);
    hear(keyScan(1, 77), Third);  // it is another map
    EXPECT_THAT(entered(), IsEmpty());
    EXPECT_THAT(m_filedAgain, IsEmpty()) << "what lies in another map takes no number";
    begin();
    hear(keyScan(1), Third);
    EXPECT_TRUE(m_intake->sharesMap());
    m_holdsMap = true;
    hear(poses({1, 9}), Third);
    heartbeat(61s);
    EXPECT_THAT(entered(), IsEmpty());
}

}  // namespace
}  // namespace leitstand::test
