#include "tests/app/services/shared_intake_fixture.h"

namespace leitstand::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST_F(SharedIntakeTest, PosesAndPlacesWaitForTheScansThatTheyLieOn) {
    begin();
    hear(poses({1, 2}));
    hear(crawlerAt(0.5), station_topic::RobotPlaces);
    EXPECT_THAT(entered(), IsEmpty());
    hear(keyScan(1));
    EXPECT_THAT(entered(), ElementsAre("scan 1"));
    hear(keyScan(2));
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
    hear(keyScan(1));
    hear(standing(1.0), station_topic::ScanBodies);
    EXPECT_THAT(entered(), ElementsAre("scan 1"));
    hear(keyScan(2));
    hear(standing(1.0), station_topic::ScanBodies);  // told again, for a station that came late
    EXPECT_THAT(entered(), ElementsAre("scan 2", "bodies"));
    hear(standing(1.5), station_topic::ScanBodies);
    EXPECT_THAT(entered(), ElementsAre("bodies"));
    EXPECT_EQ(m_state->bodies->at(2).front().baseInScan.translation().x(), 1.5);
    m_holdsMap = true;
    hear(standing(2.0), station_topic::ScanBodies);
    EXPECT_THAT(entered(), IsEmpty()) << "who makes the map says so itself";
}

TEST_F(SharedIntakeTest, WhatWasSaidLaterNeverEntersBefore) {
    begin();
    hear(keyScan(1));
    hear(poses({1, 2}, 3.0));  // its scan 2 is on its way
    hear(poses({1}, 5.0));
    EXPECT_THAT(entered(), ElementsAre("scan 1"));
    hear(keyScan(2));
    EXPECT_EQ(placeOf(1), 5.0);
    EXPECT_THAT(entered(), ElementsAre("scan 2", "poses of 2", "poses of 1"));
}

TEST_F(SharedIntakeTest, AScanThatNeverComesHoldsTheOthersUpForAMinuteOnly) {
    begin();
    hear(keyScan(1));
    hear(poses({1, 9}, 3.0));
    heartbeat(59s);
    EXPECT_THAT(entered(), ElementsAre("scan 1"));
    heartbeat(2s);
    EXPECT_THAT(entered(), ElementsAre("poses of 2"));
    EXPECT_EQ(placeOf(1), 3.0);
}

TEST_F(SharedIntakeTest, WhatIsToldAgainEntersOnce) {
    begin();
    for (int i = 0; i < 2; ++i) {
        hear(keyScan(1));
        hear(keyScan(2));
    }
    EXPECT_THAT(entered(), ElementsAre("scan 1", "scan 2"));
    begin();  // as after a restart: the mission has them
    hear(keyScan(1), Third);
    hear(keyScan(2), Third);
    hear(keyScan(3), Third);
    EXPECT_THAT(entered(), ElementsAre("scan 3"));
    EXPECT_FALSE(m_intake->isAdopted(1));
    EXPECT_EQ(m_told, "");
}

TEST_F(SharedIntakeTest, AScanThatCameAfterAKilledStationLostItsOwnCountsInsteadOfThat) {
    begin();
    hear(keyScan(1));
    hear(keyScan(2));
    hear(keyScan(1), Third);  // the same station, started anew: its log had only the first
    hear(keyScan(2, 50), Third);
    EXPECT_THAT(entered(), ElementsAre("scan 1", "scan 2", "scan 2"));
    EXPECT_EQ(m_state->keyScans->at(2).entry.stamp, at(50));
    EXPECT_EQ(m_told, "");
}

TEST_F(SharedIntakeTest, AnotherMapIsToldOnceAndNothingOfItIsTaken) {
    begin();
    hear(keyScan(1));
    hear(keyScan(2));
    (void)entered();
    hear(poses({1, 2}, 7.0), Third);
    hear(keyScan(5, 70), Third);  // not yet to be told
    hear(keyScan(1, 66), Third);
    EXPECT_THAT(m_told, HasSubstr("another map"));
    m_told.clear();
    hear(keyScan(2, 67), Third);
    hear(keyScan(6, 71), Third);
    hear(poses({1, 2}, 7.0), Third);
    hear(crawlerAt(0.5), station_topic::RobotPlaces, Third);
    VictimSample victim;
    victim.stamp = at(80);
    victim.number = 1;
    hear(victim, station_topic::Victims, Third);
    heartbeat(61s);
    EXPECT_THAT(entered(), IsEmpty());
    EXPECT_EQ(m_told, "");
    hear(poses({1}, 2.0));
    EXPECT_THAT(entered(), ElementsAre("poses of 1")) << "that of the station that makes ours goes on";
}

TEST_F(SharedIntakeTest, TheStationThatMakesTheMapHearsNobodyElses) {
    begin();
    m_holdsMap = true;
    hear(keyScan(1));
    hear(poses({1}));
    hear(crawlerAt(0.5), station_topic::RobotPlaces);
    EXPECT_THAT(entered(), IsEmpty());
    VictimSample victim;
    victim.stamp = at(80);
    victim.number = 1;
    hear(victim, station_topic::Victims);
    EXPECT_THAT(entered(), ElementsAre("victim")) << "finds are everybody's";
}

TEST_F(SharedIntakeTest, WhatIsSaidOfTheMapWhileTwoMeanToMakeItIsTakenByTheOneThatDoesNot) {
    begin();
    hear(keyScan(1));
    begin();  // after a restart: it goes on with what it held ...
    (void)entered();
    m_holdsMap = true;
    hear(keyScan(1));  // ... while another one has held it since, and tells what came meanwhile
    hear(keyScan(1001));
    hear(poses({1, 1001}, 3.0));
    heartbeat(1s);
    EXPECT_THAT(entered(), IsEmpty());
    m_holdsMap = false;
    hear(poses({1, 1001}, 4.0));
    EXPECT_THAT(entered(), ElementsAre("scan 1001", "poses of 2", "poses of 2"));
    EXPECT_EQ(placeOf(1001), 4.0);
    m_holdsMap = true;
    hear(keyScan(7), Third);  // by one that was wrong about who makes the map ...
    hear(poses({1, 1001}, 5.0), Third);
    GrantSample hold;
    hold.station = "other";
    hold.kind = GrantSample::Kind::Map;
    hold.action = GrantSample::Action::Hold;
    hear(hold, station_topic::Grants);  // ... as this one was: Other does
    m_holdsMap = false;
    heartbeat(1s);
    EXPECT_THAT(entered(), IsEmpty());
    m_holdsMap = true;
    hear(poses({1, 1001}, 5.0));
    heartbeat(11s);
    m_holdsMap = false;
    heartbeat(1s);
    EXPECT_THAT(entered(), IsEmpty()) << "who makes the map was clear for long";
}

TEST_F(SharedIntakeTest, WhoMadeTheMapBeforeThisStationDoesNotDecideForWhoMakesItNow) {
    begin();
    hear(keyScan(1));
    GrantSample hold;
    hold.station = "other";
    hold.kind = GrantSample::Kind::Map;
    hold.action = GrantSample::Action::Hold;
    hear(hold, station_topic::Grants);
    (void)entered();
    m_holdsMap = true;  // it was handed over to this one ...
    m_now += 5s;
    hear(keyScan(1), Third);  // ... until a third one takes it, whose grant comes last
    hear(poses({1}, 3.0), Third);
    m_holdsMap = false;
    hear(poses({1}, 4.0), Third);
    EXPECT_THAT(entered(), ElementsAre("poses of 1", "poses of 1"));
}

TEST_F(SharedIntakeTest, AScanThatComesBeforeAnyTellsWhoseMapItIsWaits) {
    begin();
    hear(keyScan(1));
    begin();  // after a restart
    (void)entered();
    hear(keyScan(1001), Third);  // its newest overtakes what it tells of the rest
    hear(poses({1001}, 4.0), Third);
    EXPECT_THAT(entered(), IsEmpty());
    hear(keyScan(1), Third);
    EXPECT_THAT(entered(), ElementsAre("scan 1001", "poses of 1"));
    EXPECT_TRUE(m_intake->isAdopted(1001));
    hear(keyScan(1001), Third);
    EXPECT_THAT(entered(), IsEmpty());
}

TEST_F(SharedIntakeTest, AScanThatWaitsBehindItsOwnPosesEntersBeforeThem) {
    begin();
    hear(keyScan(1));
    begin();  // after a restart: whose map it is must be told first
    (void)entered();
    hear(poses({1, 5}, 3.0));  // they overtook their scan
    hear(keyScan(5));
    EXPECT_THAT(entered(), IsEmpty());
    hear(keyScan(1));
    EXPECT_THAT(entered(), ElementsAre("scan 5", "poses of 2"));
    EXPECT_EQ(placeOf(5), 3.0);
}

TEST_F(SharedIntakeTest, WhatWaitedIsNotTakenByWhoMakesTheMapByThen) {
    begin();
    hear(keyScan(1));
    hear(poses({1, 9}, 3.0));
    m_holdsMap = true;
    heartbeat(61s);
    EXPECT_THAT(entered(), ElementsAre("scan 1"));
}

TEST_F(SharedIntakeTest, OwnWordsAreLeftOutAndNonsenseIsKeptForTheLog) {
    begin();
    hear(keyScan(1), Me);
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
        hear(poses({static_cast<std::uint64_t>(i) + 1}), crowd);
    }
    EXPECT_THAT(entered(), IsEmpty());
}

}  // namespace
}  // namespace leitstand::test
