#include "app/session/sharing/shared_intake.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/session/sharing/shared_evidence.h"
#include "core/mission/fold.h"
#include "core/mission/station_topics.h"
#include "tests/transport/dds/test_node.h"
#include "transport/convert/decode.h"
#include "transport/convert/encode.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Sender process(std::uint8_t number) {
    Sender sender;
    sender.bytes.fill(number);
    return sender;
}
const Sender Me = process(1), Other = process(2), Third = process(3);

Time at(int seconds) {
    return Time(std::chrono::seconds(1'700'000'000 + seconds));
}

KeyScanSample keyScan(std::uint64_t id, int entered = 0) {
    auto scan = std::make_shared<Scan>();
    scan->robot = "kurt3d";
    scan->points = {{1, 2, 3}};
    KeyScanSample sample;
    sample.stamp = at(entered != 0 ? entered : static_cast<int>(id));
    sample.id = id;
    sample.scan = scan;
    return sample;
}

ScanPosesSample poses(std::vector<std::uint64_t> scans, double x = 1.0) {
    ScanPosesSample sample;
    sample.stamp = at(100);
    sample.station = "other";
    for (const std::uint64_t id : scans) {
        ScanPose pose;
        pose.scan = id;
        pose.scanInMap.translation().x() = x;
        sample.poses.push_back(pose);
    }
    return sample;
}

RobotPlaceSample crawlerAt(double x) {
    RobotPlaceSample sample;
    sample.stamp = at(100);
    sample.station = "other";
    sample.robot = "crawler";
    sample.baseInMap.translation().x() = x;
    return sample;
}

/// An intake before a log of its own: what enters is folded at once.
class SharedIntakeTest : public testing::Test {
protected:
    void begin() {
        SharedIntakeSetup setup;
        setup.me = Me;
        setup.station = "us";
        setup.onJoined = [this] { ++m_joined; };
        setup.fileAgain = [this](const VictimSample& find) { m_filedAgain.push_back(find); };
        setup.mission = [this] { return m_state; };
        setup.holdsMap = [this] { return m_holdsMap; };
        setup.enter = [this](RawEvent raw) {
            raw.sequence = m_state->sequence + 1;
            auto event = decodeStationEvent(raw);
            if (!event) {
                m_entered.push_back("broken");
                return;
            }
            m_state = std::make_shared<const MissionState>(fold(*m_state, *event));
            m_entered.push_back(nameOf(event->sample));
        };
        setup.tell = [this](const std::string& text) { m_told += text + "\n"; };
        m_intake = std::make_unique<SharedIntake>(std::move(setup));
    }
    void hear(const Sample& sample, std::string_view topic, const Sender& from = Other) {
        RawEvent event;
        event.topic = topic;
        event.type = typeOf(sample);
        event.received = at(200);
        event.cdr = must(encode(sample, event.type));
        m_intake->take(std::move(event), from, m_now);
    }
    void hear(const KeyScanSample& scan, const Sender& from = Other) {
        hear(scan, station_topic::KeyScans, from);
    }
    void hear(const ScanPosesSample& sample, const Sender& from = Other) {
        hear(sample, station_topic::ScanPoses, from);
    }
    void heartbeat(std::chrono::seconds later) {
        m_now += later;
        GrantSample grant;
        grant.station = "other";
        hear(grant, station_topic::Grants);
    }
    /// What entered since, but for grants.
    [[nodiscard]] std::vector<std::string> entered() {
        std::vector<std::string> all = std::exchange(m_entered, {});
        std::erase(all, "grant");
        return all;
    }
    [[nodiscard]] double placeOf(std::uint64_t scan) const {
        return m_state->keyScans->at(scan).pose.scanInMap.translation().x();
    }
    static std::string nameOf(const Sample& sample) {
        if (const auto* scan = std::get_if<KeyScanSample>(&sample)) return "scan " + std::to_string(scan->id);
        if (const auto* some = std::get_if<ScanPosesSample>(&sample))
            return "poses of " + std::to_string(some->poses.size());
        if (std::holds_alternative<RobotPlaceSample>(sample)) return "place";
        if (std::holds_alternative<VictimSample>(sample)) return "victim";
        if (std::holds_alternative<ClockSample>(sample)) return "clock";
        if (std::holds_alternative<GrantSample>(sample)) return "grant";
        return "other";
    }

    MissionStatePtr m_state = std::make_shared<const MissionState>();
    bool m_holdsMap = false;
    int m_joined = 0;
    std::vector<VictimSample> m_filedAgain;
    SteadyTime m_now{};
    std::string m_told;
    std::vector<std::string> m_entered;
    std::unique_ptr<SharedIntake> m_intake;
};

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

TEST_F(SharedIntakeTest, TheNewestFormOfAFindAndTheNewestClockCount) {
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

TEST_F(SharedIntakeTest, AFindThatAnotherStationChangedKeepsWhereItsEvidenceStandsInThisLog) {
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

VictimSample victimFound(int found, int stamp, const std::string& station) {
    VictimSample victim;
    victim.number = 3;
    victim.found = at(found);
    victim.stamp = at(stamp);
    victim.station = station;
    return victim;
}

TEST_F(SharedIntakeTest, OfTwoFindsOfOneNumberTheFirstKeepsItAndTheOtherIsFiledAgain) {
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

TEST_F(SharedIntakeTest, AClockThatBeganByItselfGivesWay) {
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

TEST_F(SharedIntakeTest, FindsOfAMapThatNobodyKnowsYetWaitUntilItIsKnown) {
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
