#include "tests/app/services/shared_intake_fixture.h"

#include "core/event/find_sample.h"
#include "core/event/station_samples.h"
#include "core/mission/state/find_state.h"

namespace leitstand::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using SharedFinds = SharedIntakeTest;

TEST_F(SharedFinds, TheNewestFormOfAFindAndTheNewestClockCount) {
    begin();
    FindSample victim;
    victim.stamp = at(80);
    victim.number = 1;
    receive(victim, station_topic::Victims);
    receive(victim, station_topic::Victims, Third);
    victim.stamp = at(79);
    receive(victim, station_topic::Victims);
    EXPECT_THAT(entered(), ElementsAre("victim"));
    victim.stamp = at(81);
    receive(victim, station_topic::Victims, Third);
    ClockSample clock;
    clock.stamp = at(10);
    receive(clock, station_topic::Clock);
    clock.stamp = at(9);
    receive(clock, station_topic::Clock);
    EXPECT_THAT(entered(), ElementsAre("victim", "clock"));
}

TEST_F(SharedFinds, AFindThatAnotherStationChangedKeepsWhereItsEvidenceStandsInThisLog) {
    begin();
    FindSample ours;
    ours.stamp = at(80);
    ours.number = 1;
    ours.evidence = {{"picture", "/kurt3d/left", 512, at(79)}, {"gas", "/kurt3d/co2", 513, at(78)}};
    receive(ours, station_topic::Victims);
    FindSample changed = forOthers(ours).get<FindSample>();
    EXPECT_EQ(changed.evidence[0].sequence, 0u);
    changed.stamp = at(90);
    changed.status = FindSample::Status::Confirmed;
    changed.evidence.push_back({"picture", "/crawler/left", 0, at(89)});
    receive(changed, station_topic::Victims, Third);
    const FindSample& kept = m_state->finds->at({FindSample::Kind::Victim, 1}).victim;
    EXPECT_EQ(kept.status, FindSample::Status::Confirmed);
    ASSERT_EQ(kept.evidence.size(), 3u);
    EXPECT_EQ(kept.evidence[0].sequence, 512u);
    EXPECT_EQ(kept.evidence[1].sequence, 513u);
    EXPECT_EQ(kept.evidence[2].sequence, 0u) << "another log has it";
}

TEST_F(SharedFinds, OfTwoFindsOfOneNumberTheFirstKeepsItAndTheOtherIsFiledAgain) {
    begin();
    const auto number3 = [&] { return m_state->finds->at({FindSample::Kind::Victim, 3}).victim; };
    receive(victimFound(50, 50, "us"), station_topic::Victims);  // as this station filed it, unheard
    receive(victimFound(40, 40, "other"), station_topic::Victims);
    EXPECT_EQ(number3().found, at(40));
    ASSERT_EQ(m_filedAgain.size(), 1u);
    EXPECT_EQ(m_filedAgain.front().found, at(50));
    receive(victimFound(60, 90, "third"), station_topic::Victims, Third);  // who filed that does the same
    EXPECT_EQ(number3().found, at(40));
    receive(victimFound(40, 41, "third"), station_topic::Victims, Third);
    EXPECT_EQ(number3().station, "third");
    EXPECT_EQ(m_filedAgain.size(), 1u);
}

TEST_F(SharedFinds, AClockThatBeganByItselfGivesWay) {
    begin();
    ClockSample ours;
    ours.stamp = at(50);
    ours.station = "us";
    ours.running = true;
    receive(ours, station_topic::Clock);
    ClockSample set = ours;
    set.station = "other";
    set.stamp = at(10);  // long before this station came
    set.limit = std::chrono::minutes(20);
    receive(set, station_topic::Clock);
    EXPECT_EQ(m_state->clock->sample.limit, std::chrono::minutes(20));
    ClockSample began = ours;
    began.station = "third";
    began.stamp = at(9);
    receive(began, station_topic::Clock, Third);
    EXPECT_EQ(m_state->clock->sample.station, "other") << "an operator set that";
}

TEST_F(SharedFinds, FindsOfAMapThatNobodyKnowsYetWaitUntilItIsKnown) {
    begin();
    receive(keyScan(1));
    EXPECT_EQ(m_joined, 1);
    EXPECT_TRUE(m_intake->sharesMap());
    begin();  // after a restart
    EXPECT_FALSE(m_intake->sharesMap()) << "nobody confirmed it yet";
    (void)entered();
    GrantSample grant;
    grant.kind = GrantSample::Kind::Map;
    grant.station = "third";
    receive(grant, station_topic::Grants, Third);
    receive(victimFound(40, 40, "third"), station_topic::Victims, Third);
    EXPECT_THAT(entered(), IsEmpty());
    receive(keyScan(1), Third);
    EXPECT_THAT(entered(), ElementsAre("victim"));
    begin();
    receive(grant, station_topic::Grants, Third);
    receive(victimFound(30, 30, "third"), station_topic::Victims, Third);
    receive(keyScan(1, 77), Third);  // it is another map
    EXPECT_THAT(entered(), IsEmpty());
    EXPECT_THAT(m_filedAgain, IsEmpty()) << "what lies in another map takes no number";
    begin();
    receive(keyScan(1), Third);
    EXPECT_TRUE(m_intake->sharesMap());
    m_holdsMap = true;
    receive(poses({1, 9}), Third);
    heartbeat(61s);
    EXPECT_THAT(entered(), IsEmpty());
}

}  // namespace
}  // namespace leitstand::test
