#include "tests/app/services/shared_intake_fixture.h"

#include "core/event/find_sample.h"
#include "core/event/scan_bodies.h"
#include "core/event/station_samples.h"
#include "core/mission/state/scan_state.h"

namespace leitstand::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST_F(SharedIntakeTest, PosesAndPlacesWaitForTheScansThatTheyLieOn) {
    begin();
    receive(poses({1, 2}));
    receive(crawlerAt(0.5), station_topic::RobotPlaces);
    EXPECT_THAT(entered(), IsEmpty());
    receive(keyScan(1));
    EXPECT_THAT(entered(), ElementsAre("scan 1"));
    receive(keyScan(2));
    EXPECT_THAT(entered(), ElementsAre("scan 2", "poses of 2", "place"));
    EXPECT_EQ(placeOf(2), 1.0);
    EXPECT_TRUE(m_intake->isAdopted(2));
    EXPECT_THAT(*m_state->remarks, IsEmpty());
}

TEST_F(SharedIntakeTest, RobotsThatAreLeftOutOfAScanComeAfterItAndOnce) {
    begin();
    const auto standing = [](double x) {
        BodyInScan body{"crawler", {{0.2, 0.0}, {0.0, 0.2}, {-0.2, 0.0}}, 0.4, Pose::Identity(), 0.1};
        body.baseInScan.translation().x() = x;
        return ScanBodiesSample{at(100), "other", {{2, {body}}}};
    };
    receive(keyScan(1));
    receive(standing(1.0), station_topic::ScanBodies);
    EXPECT_THAT(entered(), ElementsAre("scan 1"));
    receive(keyScan(2));
    receive(standing(1.0), station_topic::ScanBodies);  // told again, for a station that came late
    EXPECT_THAT(entered(), ElementsAre("scan 2", "bodies"));
    receive(standing(1.5), station_topic::ScanBodies);
    EXPECT_THAT(entered(), ElementsAre("bodies"));
    EXPECT_EQ(m_state->bodies->at(2).front().baseInScan.translation().x(), 1.5);
    m_holdsMap = true;
    receive(standing(2.0), station_topic::ScanBodies);
    EXPECT_THAT(entered(), IsEmpty()) << "who makes the map says so itself";
}

TEST_F(SharedIntakeTest, WhatWasSaidLaterNeverEntersBefore) {
    begin();
    receive(keyScan(1));
    receive(poses({1, 2}, 3.0));  // its scan 2 is on its way
    receive(poses({1}, 5.0));
    EXPECT_THAT(entered(), ElementsAre("scan 1"));
    receive(keyScan(2));
    EXPECT_EQ(placeOf(1), 5.0);
    EXPECT_THAT(entered(), ElementsAre("scan 2", "poses of 2", "poses of 1"));
}

TEST_F(SharedIntakeTest, AScanThatNeverComesHoldsTheOthersUpForAMinuteOnly) {
    begin();
    receive(keyScan(1));
    receive(poses({1, 9}, 3.0));
    heartbeat(59s);
    EXPECT_THAT(entered(), ElementsAre("scan 1"));
    heartbeat(2s);
    EXPECT_THAT(entered(), ElementsAre("poses of 2"));
    EXPECT_EQ(placeOf(1), 3.0);
}

TEST_F(SharedIntakeTest, WhatIsToldAgainEntersOnce) {
    begin();
    for (int i = 0; i < 2; ++i) {
        receive(keyScan(1));
        receive(keyScan(2));
    }
    EXPECT_THAT(entered(), ElementsAre("scan 1", "scan 2"));
    begin();  // as after a restart: the mission has them
    receive(keyScan(1), Third);
    receive(keyScan(2), Third);
    receive(keyScan(3), Third);
    EXPECT_THAT(entered(), ElementsAre("scan 3"));
    EXPECT_FALSE(m_intake->isAdopted(1));
    EXPECT_EQ(m_reported, "");
}

TEST_F(SharedIntakeTest, AScanThatCameAfterAKilledStationLostItsOwnCountsInsteadOfThat) {
    begin();
    receive(keyScan(1));
    receive(keyScan(2));
    receive(keyScan(1), Third);  // the same station, started anew: its log had only the first
    receive(keyScan(2, 50), Third);
    EXPECT_THAT(entered(), ElementsAre("scan 1", "scan 2", "scan 2"));
    EXPECT_EQ(m_state->keyScans->at(2).entry.stamp, at(50));
    EXPECT_EQ(m_reported, "");
}

TEST_F(SharedIntakeTest, AnotherMapIsToldOnceAndNothingOfItIsTaken) {
    begin();
    receive(keyScan(1));
    receive(keyScan(2));
    (void)entered();
    receive(poses({1, 2}, 7.0), Third);
    receive(keyScan(5, 70), Third);  // not yet to be told
    receive(keyScan(1, 66), Third);
    EXPECT_THAT(m_reported, HasSubstr("another map"));
    m_reported.clear();
    receive(keyScan(2, 67), Third);
    receive(keyScan(6, 71), Third);
    receive(poses({1, 2}, 7.0), Third);
    receive(crawlerAt(0.5), station_topic::RobotPlaces, Third);
    FindSample victim;
    victim.stamp = at(80);
    victim.number = 1;
    receive(victim, station_topic::Victims, Third);
    heartbeat(61s);
    EXPECT_THAT(entered(), IsEmpty());
    EXPECT_EQ(m_reported, "");
    receive(poses({1}, 2.0));
    EXPECT_THAT(entered(), ElementsAre("poses of 1")) << "that of the station that makes ours goes on";
}

TEST_F(SharedIntakeTest, TheStationThatMakesTheMapHearsNobodyElses) {
    begin();
    m_holdsMap = true;
    receive(keyScan(1));
    receive(poses({1}));
    receive(crawlerAt(0.5), station_topic::RobotPlaces);
    EXPECT_THAT(entered(), IsEmpty());
    FindSample victim;
    victim.stamp = at(80);
    victim.number = 1;
    receive(victim, station_topic::Victims);
    EXPECT_THAT(entered(), ElementsAre("victim")) << "finds are everybody's";
}

TEST_F(SharedIntakeTest, WhatIsSaidOfTheMapWhileTwoMeanToMakeItIsTakenByTheOneThatDoesNot) {
    begin();
    receive(keyScan(1));
    begin();  // after a restart: it goes on with what it held ...
    (void)entered();
    m_holdsMap = true;
    receive(keyScan(1));  // ... while another one has held it since, and tells what came meanwhile
    receive(keyScan(1001));
    receive(poses({1, 1001}, 3.0));
    heartbeat(1s);
    EXPECT_THAT(entered(), IsEmpty());
    m_holdsMap = false;
    receive(poses({1, 1001}, 4.0));
    EXPECT_THAT(entered(), ElementsAre("scan 1001", "poses of 2", "poses of 2"));
    EXPECT_EQ(placeOf(1001), 4.0);
    m_holdsMap = true;
    receive(keyScan(7), Third);  // by one that was wrong about who makes the map ...
    receive(poses({1, 1001}, 5.0), Third);
    GrantSample hold;
    hold.station = "other";
    hold.kind = GrantSample::Kind::Map;
    hold.action = GrantSample::Action::Hold;
    receive(hold, station_topic::Grants);  // ... as this one was: Other does
    m_holdsMap = false;
    heartbeat(1s);
    EXPECT_THAT(entered(), IsEmpty());
    m_holdsMap = true;
    receive(poses({1, 1001}, 5.0));
    heartbeat(11s);
    m_holdsMap = false;
    heartbeat(1s);
    EXPECT_THAT(entered(), IsEmpty()) << "who makes the map was clear for long";
}

TEST_F(SharedIntakeTest, WhoMadeTheMapBeforeThisStationDoesNotDecideForWhoMakesItNow) {
    begin();
    receive(keyScan(1));
    GrantSample hold;
    hold.station = "other";
    hold.kind = GrantSample::Kind::Map;
    hold.action = GrantSample::Action::Hold;
    receive(hold, station_topic::Grants);
    (void)entered();
    m_holdsMap = true;  // it was handed over to this one ...
    m_now += 5s;
    receive(keyScan(1), Third);  // ... until a third one takes it, whose grant comes last
    receive(poses({1}, 3.0), Third);
    m_holdsMap = false;
    receive(poses({1}, 4.0), Third);
    EXPECT_THAT(entered(), ElementsAre("poses of 1", "poses of 1"));
}

TEST_F(SharedIntakeTest, AScanThatComesBeforeAnyTellsWhoseMapItIsWaits) {
    begin();
    receive(keyScan(1));
    begin();  // after a restart
    (void)entered();
    receive(keyScan(1001), Third);  // its newest overtakes what it tells of the rest
    receive(poses({1001}, 4.0), Third);
    EXPECT_THAT(entered(), IsEmpty());
    receive(keyScan(1), Third);
    EXPECT_THAT(entered(), ElementsAre("scan 1001", "poses of 1"));
    EXPECT_TRUE(m_intake->isAdopted(1001));
    receive(keyScan(1001), Third);
    EXPECT_THAT(entered(), IsEmpty());
}

TEST_F(SharedIntakeTest, AScanThatWaitsBehindItsOwnPosesEntersBeforeThem) {
    begin();
    receive(keyScan(1));
    begin();  // after a restart: whose map it is must be told first
    (void)entered();
    receive(poses({1, 5}, 3.0));  // they overtook their scan
    receive(keyScan(5));
    EXPECT_THAT(entered(), IsEmpty());
    receive(keyScan(1));
    EXPECT_THAT(entered(), ElementsAre("scan 5", "poses of 2"));
    EXPECT_EQ(placeOf(5), 3.0);
}

TEST_F(SharedIntakeTest, WhatWaitedIsNotTakenByWhoMakesTheMapByThen) {
    begin();
    receive(keyScan(1));
    receive(poses({1, 9}, 3.0));
    m_holdsMap = true;
    heartbeat(61s);
    EXPECT_THAT(entered(), ElementsAre("scan 1"));
}

TEST_F(SharedIntakeTest, OwnWordsAreLeftOutAndNonsenseIsKeptForTheLog) {
    begin();
    receive(keyScan(1), Me);
    EXPECT_THAT(entered(), IsEmpty());
    RawEvent event;
    event.topic = station_topic::ScanPoses;
    event.type = "leitstand_msgs/msg/ScanPoses";
    event.cdr = std::make_shared<const std::vector<std::byte>>(3);
    m_intake->take(event, Other, m_now);
    EXPECT_THAT(entered(), ElementsAre("broken"));
    for (int i = 0; i < 1000; ++i) {  // whoever they are
        Sender crowd;
        crowd.bytes[0] = static_cast<std::uint8_t>(i);
        crowd.bytes[1] = static_cast<std::uint8_t>(i / 256);
        receive(poses({static_cast<std::uint64_t>(i) + 1}), crowd);
    }
    EXPECT_THAT(entered(), IsEmpty());
}

}  // namespace
}  // namespace leitstand::test
