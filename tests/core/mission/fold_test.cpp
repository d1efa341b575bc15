#include "core/mission/state/fold.h"

#include <optional>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/event/candidate_sample.h"
#include "core/event/find_sample.h"
#include "core/event/map_samples.h"
#include "core/event/motion_samples.h"
#include "core/event/scan_bodies.h"
#include "core/event/status_samples.h"
#include "core/mission/state/crop_state.h"
#include "core/mission/state/decision.h"
#include "core/mission/state/find_state.h"
#include "core/mission/state/scan_state.h"
#include "tests/core/mission/event_stream.h"

namespace leitstand {
namespace {

using test::at;
using test::event;
using test::keyScan;
using test::moved;
using test::undo;
using test::victim;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

const FindKey V1{FindSample::Kind::Victim, 1U};

MissionState folded(const std::vector<Event>& events) {
    Fold fold;
    for (const Event& event : events) fold.add(event);
    return fold.state();
}

TEST(Fold, KeepsWhatARobotSaidLast) {
    BatterySample battery;
    battery.voltage = 24.0;
    OdometrySample odometry;
    odometry.header.stamp = at(5);
    odometry.baseInOdom.translation().x() = 2.0;
    const MissionState state = folded(
        {event(1, OdometrySample{}, "kurt3d"), event(2, odometry, "kurt3d"), event(3, battery, "kurt3d"),
         event(4,
               ModeSample{.header = {}, .mode = "explore", .autonomous = true, .reason = {}, .available = {}},
               "crawler")});
    ASSERT_THAT(state.robots, SizeIs(2));
    const RobotState& kurt = *state.robots.at("kurt3d");
    EXPECT_EQ(kurt.odometry->sample.baseInOdom.translation().x(), 2.0);
    EXPECT_EQ(kurt.battery->sample.voltage, 24.0);
    EXPECT_EQ(state.robots.at("crawler")->mode->sample.mode, "explore");
    const StreamState& stream = kurt.streams.at(event(1, OdometrySample{}, "kurt3d").topic);
    EXPECT_EQ(stream.events, 2U);
    EXPECT_EQ(stream.received, at(20));
    EXPECT_EQ(stream.stamp, at(5));
    EXPECT_EQ(state.first, at(10));
    EXPECT_EQ(state.last, at(40));
    EXPECT_EQ(state.events, 4U);
}

/// A battery that gives @p ampere.
BatterySample giving(double ampere) {
    BatterySample battery;
    battery.current = -ampere;
    battery.charge = 1.0;
    return battery;
}

TEST(Fold, ABatterysLoadIsTheMeanOfTheLastMinute) {
    Fold fold;
    std::uint64_t sequence = 0;
    const auto goOn = [&](int seconds, double ampere) {
        for (int second = 0; second < seconds; ++second)
            fold.add(event(sequence += 100, giving(ampere), "kurt3d"));  // once a second
        return -fold.state().robots.at("kurt3d")->load.current;
    };
    EXPECT_NEAR(goOn(30, 1.0), 1.0, 1e-9);
    EXPECT_LT(goOn(1, 9.0), 1.3) << "it starts to drive";
    EXPECT_NEAR(goOn(29, 9.0), 5.0, 0.3) << "half a minute each";
    EXPECT_NEAR(goOn(300, 9.0), 9.0, 0.1);
    EXPECT_EQ(goOn(1, -2.0), -2.0) << "charging";
    EXPECT_EQ(goOn(1, 3.0), 3.0) << "what was before does not count any more";
    sequence += 6'100;  // nothing was heard for a minute
    EXPECT_NEAR(goOn(1, 7.0), 7.0, 1e-9);
}

TEST(Fold, ACandidateKeepsWhoToldItFirstAndHowThatRobotDrove) {
    const auto driving = [](bool autonomous) {
        ModeSample mode;
        mode.autonomous = autonomous;
        return mode;
    };
    CandidateSample candidate;
    candidate.id = 3;
    candidate.stamp = at(20);
    candidate.cues = {{.kind = "heat", .robot = "kurt3d"}};
    CandidateSample again = candidate;
    again.stamp = at(90);
    again.cues = {{.kind = "heat", .robot = "crawler"}};
    CandidateSample other = again;
    other.id = 4;
    const MissionState state = folded({event(1, driving(true), "kurt3d"), event(2, candidate),
                                       event(3, driving(false), "kurt3d"), event(4, again), event(5, other)});
    const CandidateState& kept = state.candidates->at(3);
    EXPECT_EQ(kept.candidate.stamp, at(90));
    EXPECT_EQ(kept.firstReport.stamp, at(20));
    EXPECT_EQ(kept.firstReport.robot, "kurt3d");
    EXPECT_EQ(kept.firstReport.autonomous, true);
    EXPECT_EQ(state.candidates->at(4).firstReport.autonomous, std::nullopt)
        << "nobody said how the crawler drives";
}

TEST(Fold, FindsOfEveryKindHaveTheirOwnNumbers) {
    FindSample sign = victim(1, "sign");
    sign.kind = FindSample::Kind::Hazard;
    const MissionState state = folded({event(1, victim(1, "a")), event(2, sign)});
    ASSERT_THAT(*state.finds, SizeIs(2));
    EXPECT_EQ(state.finds->at({FindSample::Kind::Hazard, 1U}).victim.text, "sign");
    EXPECT_EQ(nameOf(sign.kind, sign.number), "H1");
}

TEST(Fold, TheNewestOfACandidateCountsAndMovesWithItsScan) {
    CandidateSample candidate;
    candidate.id = 7;
    candidate.scan = 3;
    candidate.positionInScan = {1.0, 0.0, 0.0};
    CandidateSample surer = candidate;
    surer.confidence = 0.9;
    const MissionState state =
        folded({event(1, keyScan(3, 0.0)), event(2, candidate), event(3, surer), event(4, moved(3, 5.0))});
    ASSERT_THAT(*state.candidates, SizeIs(1));
    const CandidateState& kept = state.candidates->at(7);
    EXPECT_EQ(kept.first, 2U);
    EXPECT_EQ(kept.sequence, 3U);
    EXPECT_EQ(kept.candidate.confidence, 0.9);
    const Eigen::Vector3d expected = state.keyScans->at(3).pose.scanInMap * candidate.positionInScan;
    EXPECT_NEAR((positionInMap(state, kept.candidate) - expected).norm(), 0.0, 1e-9);
    EXPECT_GT(expected.x(), 5.0);
}

TEST(Fold, TheNewestInformationOfTheMissionCounts) {
    const MissionState state =
        folded({event(1, MissionInfoSample{.team = "A"}), event(2, MissionInfoSample{.team = "B"})});
    EXPECT_EQ(state.info->sample.team, "B");
}

TEST(Fold, ContactsAreCountedWhereTheyHappenedAcrossRestarts) {
    OdometrySample odometry;
    odometry.baseInOdom.translation().x() = 2.0;
    const auto bumps = [](std::uint32_t hits) {
        return BumpSample{.header = {}, .bumpers = {{"front", true, hits}}};
    };
    const MissionState state =
        folded({event(1, bumps(1), "kurt3d"), event(2, odometry, "kurt3d"), event(3, bumps(3), "kurt3d"),
                event(4, bumps(3), "kurt3d"), event(5, bumps(2), "kurt3d")});
    const auto& contacts = state.robots.at("kurt3d")->contacts;
    ASSERT_THAT(contacts, SizeIs(3));
    EXPECT_EQ(contacts[0].hits, 1U);
    EXPECT_FALSE(contacts[0].baseInOdom);
    EXPECT_EQ(contacts[1].hits, 2U);
    EXPECT_EQ(contacts[1].baseInOdom->translation().x(), 2.0);
    EXPECT_EQ(contacts[2].hits, 2U) << "it started again and counts from zero";
}

TEST(Fold, ContactsBeforeTheMissionAreNoneOfIt) {
    const auto bumps = [](std::uint32_t front, bool pressed) {
        return BumpSample{.header = {}, .bumpers = {{"front", pressed, front}, {"rear", false, 4}}};
    };
    const MissionState first = folded({event(1, bumps(7, false), "kurt3d")});
    EXPECT_THAT(first.robots.at("kurt3d")->contacts, SizeIs(0)) << "it drove before somebody recorded";
    const MissionState next =
        folded({event(1, bumps(7, false), "kurt3d"), event(2, bumps(8, true), "kurt3d")});
    ASSERT_THAT(next.robots.at("kurt3d")->contacts, SizeIs(1));
    EXPECT_EQ(next.robots.at("kurt3d")->contacts[0].hits, 1U);
    const MissionState held = folded({event(1, bumps(7, true), "kurt3d")});
    ASSERT_THAT(held.robots.at("kurt3d")->contacts, SizeIs(1)) << "it touches something now";
    EXPECT_EQ(held.robots.at("kurt3d")->contacts[0].hits, 1U);
}

TEST(Fold, IsPure) {
    const MissionState before = folded({event(1, victim(1, "a"))});
    const auto bytes = serialised(before);
    const MissionState after = fold(before, event(2, victim(1, "b")));
    EXPECT_EQ(serialised(before), bytes);
    EXPECT_EQ(before.finds->at(V1).victim.text, "a");
    EXPECT_EQ(after.finds->at(V1).victim.text, "b");
}

TEST(Fold, TheNewestFormOfAVictimCountsAndUndoTakesItBack) {
    std::vector<Event> events = {event(1, victim(1, "a")), event(2, victim(1, "b")), event(3, victim(2, "c")),
                                 event(4, undo(2))};
    EXPECT_EQ(folded(events).finds->at(V1).victim.text, "a");
    events.push_back(event(5, undo(1)));
    EXPECT_THAT(*folded(events).finds, SizeIs(1));
    events.push_back(event(6, undo(4)));  // b is there again, a is not
    const MissionState state = folded(events);
    EXPECT_EQ(state.finds->at(V1).victim.text, "b");
    EXPECT_EQ(state.finds->at(V1).filed, 2U);
    EXPECT_TRUE(decisionAt(state, 4)->undone);
    EXPECT_THAT(*state.remarks, IsEmpty());
    events.push_back(event(7, undo(6)));
    EXPECT_THAT(*folded(events).finds, SizeIs(1));
}

TEST(Fold, UndoOfSomethingUnknownIsTold) {
    BatterySample battery;
    battery.voltage = 24.0;
    const MissionState state =
        folded({event(1, OdometrySample{}, "kurt3d"), event(2, undo(1)), event(3, undo(77)),
                event(4, undo(4)), event(5, victim(1, "a")), event(6, undo(5)), event(7, undo(5))});
    ASSERT_THAT(*state.remarks, SizeIs(4));
    EXPECT_THAT((*state.remarks)[0].text, HasSubstr("undo of event 1"));
    EXPECT_THAT((*state.remarks)[1].text, HasSubstr("undo of event 77"));
    EXPECT_THAT((*state.remarks)[3].text, HasSubstr("undone already"));
    EXPECT_THAT(*state.finds, IsEmpty());
}

TEST(Fold, CorrectionsMoveScansAndTheVictimsThatHangOnThem) {
    FindSample filed = victim(1, "a");
    filed.scan = 1;
    filed.positionInScan = {1.0, 0.0, 0.0};
    ScanPosesSample correction = moved(1, 0.0);
    correction.poses[0].scanInMap.translation().y() = 5.0;
    std::vector<Event> events = {event(1, keyScan(1, 0.0)), event(2, filed), event(3, correction)};
    EXPECT_TRUE(positionInMap(folded(events), filed).isApprox(Eigen::Vector3d(1, 5, 0)));
    EXPECT_EQ(folded(events).keyScans->at(1).sequence, 1U);
    EXPECT_EQ(folded(events).keyScans->at(1).entry.points, 100U);
    events.push_back(event(4, undo(3)));
    EXPECT_TRUE(positionInMap(folded(events), filed).isApprox(Eigen::Vector3d(1, 0, 0)));
    events.push_back(event(5, undo(1)));
    EXPECT_THAT(*folded(events).keyScans, IsEmpty());
}

TEST(Fold, TheMapsAreaIsTheNewestThatIsNotTakenBack) {
    MapCropSample room{
        .stamp = {}, .station = "s", .polygon = {{0.0, 0.0}, {4.0, 0.0}, {4.0, 3.0}}, .ceiling = 2.0};
    MapCropSample open{.stamp = {}, .station = "s", .polygon = {}};
    std::vector<Event> events = {event(1, room), event(2, open)};
    EXPECT_THAT(folded(events).crop->sample.polygon, IsEmpty());
    events.push_back(event(3, undo(2)));
    EXPECT_THAT(folded(events).crop->sample.polygon, SizeIs(3));
    EXPECT_EQ(folded(events).crop->sequence, 1U);
    events.push_back(event(4, undo(1)));
    EXPECT_EQ(folded(events).crop, nullptr);
    events.push_back(event(5, undo(3)));
    EXPECT_THAT(folded(events).crop->sample.polygon, IsEmpty());
}

TEST(Fold, OfOtherRobotsInAScanTheNewestIsKnownAndGoesWithTheScan) {
    const auto shifted = [](double x) { return poseFrom({x, 0.0, 0.0}, 0, 0, 0); };
    const auto standing = [&](std::uint64_t scan, double x) {
        return ScanBodiesSample{
            {}, "s", {{scan, {{"crawler", {{0.2, 0.0}, {0.0, 0.2}, {-0.2, 0.0}}, 0.4, shifted(x), 0.1}}}}};
    };
    std::vector<Event> events = {event(1, keyScan(1, 0.0)), event(2, standing(1, 1.0)),
                                 event(3, keyScan(2, 0.0)), event(4, standing(2, 2.0)),
                                 event(5, standing(1, 3.0))};
    ASSERT_THAT(folded(events).bodies->at(1), SizeIs(1));
    EXPECT_TRUE(folded(events).bodies->at(1)[0].baseInScan.isApprox(shifted(3.0)));
    EXPECT_EQ(folded(events).bodies->at(2)[0].robot, "crawler");
    events.push_back(event(6, moved(1, 1.0)));
    events.push_back(event(7, undo(6)));
    EXPECT_TRUE(folded(events).bodies->at(1)[0].baseInScan.isApprox(shifted(3.0))) << "undo is of the poses";
    events.push_back(event(8, keyScan(1, 0.5)));
    EXPECT_FALSE(folded(events).bodies->contains(1)) << "another scan by that number";
    EXPECT_TRUE(folded(events).bodies->contains(2));
}

TEST(Fold, GrantsFollowTheHigherTerm) {
    GrantSample hold{.stamp = {},
                     .station = "a",
                     .title = "A",
                     .kind = GrantSample::Kind::Drive,
                     .action = GrantSample::Action::Hold,
                     .robot = "kurt3d",
                     .other = {},
                     .term = 2};
    GrantSample older = hold;
    older.station = "b";
    older.term = 1;
    const MissionState state = folded({event(1, hold), event(2, older)});
    const MissionState::GrantKey key{GrantSample::Kind::Drive, "kurt3d"};
    EXPECT_EQ(state.grants->at(key).station, "a");
    hold.action = GrantSample::Action::Release;
    EXPECT_EQ(fold(state, event(3, hold)).grants->at(key).station, "");
}

TEST(Fold, EventsOutOfOrderAreToldAndLeftOut) {
    const MissionState state =
        folded({event(5, victim(1, "a")), event(5, victim(1, "b")), event(4, victim(2, "c"))});
    EXPECT_THAT(*state.remarks, SizeIs(2));
    EXPECT_EQ(state.finds->at(V1).victim.text, "a");
    EXPECT_EQ(state.events, 1U);
}

Event diagnostics(std::uint64_t sequence, const std::string& robot, std::vector<DiagnosticStatus> statuses) {
    Event made = event(sequence, DiagnosticsSample{.header = {}, .statuses = std::move(statuses)}, robot);
    made.topic = "/diagnostics";
    return made;
}

DiagnosticStatus status(const std::string& name, const std::string& message) {
    return {DiagnosticStatus::Level::Ok, name, message, "h", {}};
}

TEST(Fold, AMessageOnASharedTopicReachesEveryRobotItIsAbout) {
    const std::vector<Event> events = {
        diagnostics(1, "crawler", {status("motor", "cold")}),
        diagnostics(1, "kurt3d", {status("motor", "warm")}),
        diagnostics(1, "kurt3d", {status("motor", "twice")}),  // once for each, no more
        event(2, OdometrySample{}, "kurt3d")};
    const MissionState state = folded(events);
    EXPECT_EQ(state.robots.at("crawler")->diagnostics->sample.statuses[0].message, "cold");
    EXPECT_EQ(state.robots.at("kurt3d")->diagnostics->sample.statuses[0].message, "warm");
    EXPECT_THAT(*state.remarks, SizeIs(1));
    EXPECT_EQ(state.sequence, 2U);
}

TEST(Fold, DiagnosticsOfSeveralPartsAddUp) {
    std::vector<Event> events = {diagnostics(1, "kurt3d", {status("motor", "cold"), status("scanner", "ok")}),
                                 diagnostics(2, "kurt3d", {}),  // was about others
                                 diagnostics(3, "kurt3d", {status("motor", "warm")})};
    const auto merged = folded(events).robots.at("kurt3d")->diagnostics->sample.statuses;
    ASSERT_THAT(merged, SizeIs(2));
    EXPECT_EQ(merged[0].name, "scanner");
    EXPECT_EQ(merged[1].message, "warm");
    for (std::uint64_t i = 4; i < 1'000; ++i) {
        events.push_back(diagnostics(i, "kurt3d", {status("part " + std::to_string(i), "")}));
    }
    EXPECT_THAT(folded(events).robots.at("kurt3d")->diagnostics->sample.statuses, SizeIs(256));
}

TEST(Fold, SnapshotsStayAsTheyWereWhileTheFoldGoesOn) {
    Fold fold;
    const auto events = test::randomMission(3, 600);
    std::vector<std::jthread> readers;
    for (std::size_t i = 0; i < events.size(); ++i) {
        fold.add(events[i]);
        if (i % 50 != 0) continue;
        readers.emplace_back([snapshot = fold.snapshot()] {
            const auto bytes = serialised(*snapshot);
            const MissionState copy = *snapshot;
            EXPECT_EQ(serialised(copy), bytes);
        });
    }
}

}  // namespace
}  // namespace leitstand
