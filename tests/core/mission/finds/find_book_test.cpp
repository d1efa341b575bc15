#include "core/mission/finds/find_book.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/event/candidate_sample.h"
#include "core/event/find_sample.h"
#include "core/event/map_samples.h"
#include "core/event/scan_pose.h"
#include "core/event/status_samples.h"
#include "core/mission/state/decisions.h"
#include "core/mission/state/find_state.h"
#include "core/mission/state/fold.h"

namespace leitstand {
namespace {

using Kind = FindSample::Kind;
using Status = FindSample::Status;
using SignState = VictimSign::State;
using testing::SizeIs;

const Time Now{std::chrono::seconds(100)};

Event event(std::uint64_t sequence, Sample sample) {
    return {sequence, Now, "", "/leitstand/victims", std::nullopt, "", std::move(sample)};
}

/// A mission that files what it is told.
struct Mission {
    MissionState state;
    std::uint64_t sequence = 0;

    void publish(const Sample& sample) { state = fold(std::move(state), event(++sequence, sample)); }
    FindKey file(const FrozenEvidence& frozen, Kind kind = Kind::Victim) {
        const FindSample sample = filed(state, kind, frozen, "s", Now);
        publish(sample);
        return {sample.kind, sample.number};
    }
    const FindSample& at(const FindKey& key) const { return state.finds->at(key).victim; }
};

FrozenEvidence seenAt(double x) {
    FrozenEvidence frozen;
    frozen.found = Now;
    frozen.robot = "kurt3d";
    frozen.positionInMap = {x, 0.0, 0.3};
    frozen.heat = 33.0;
    frozen.evidence = {{"picture", "/kurt3d/left", static_cast<std::uint64_t>(100 * x) + 1, Now}};
    return frozen;
}

TEST(FindBook, WhatIsFrozenIsANewFindOrJoinsTheOneThatIsThere) {
    Mission mission;
    EXPECT_EQ(mission.file(seenAt(1.0)), FindKey(Kind::Victim, 1U));
    EXPECT_EQ(mission.file(seenAt(1.3)), FindKey(Kind::Victim, 1U));
    EXPECT_EQ(mission.file(seenAt(3.0)), FindKey(Kind::Victim, 2U));
    EXPECT_EQ(mission.file(seenAt(1.0), Kind::Hazard), FindKey(Kind::Hazard, 1U));
    const FindSample& first = mission.at({Kind::Victim, 1U});
    EXPECT_THAT(first.evidence, SizeIs(2));
    EXPECT_EQ(first.positionInMap.x(), 1.0) << "the first look counts until the operator moves it";
    EXPECT_EQ(first.heat.state, SignState::Present);
    EXPECT_EQ(first.heat.value, 33.0);
    EXPECT_EQ(first.status, Status::Hypothesis);
}

TEST(FindBook, AFindHangsOnAScanThatCountsAndShowsItsPlace) {
    Mission mission;
    const auto enters = [&](std::uint64_t id, const std::string& robot, double x, ScanTrust trust) {
        Scan scan;
        scan.robot = robot;
        KeyScanSample key;
        key.id = id;
        key.scan = std::make_shared<const Scan>(scan);
        mission.publish(key);
        ScanPosesSample poses;
        poses.poses = {{.scan = id, .scanInMap = Pose(Eigen::Translation3d(x, 0.0, 0.0)), .trust = trust}};
        mission.publish(poses);
    };
    const auto beside = [&](const std::string& robot, double x) {
        return scanBeside(mission.state, robot, {x, 0.0, 0.0});
    };
    EXPECT_EQ(beside("kurt3d", 1.0), 0U) << "there is none";
    enters(1, "kurt3d", 0.0, ScanTrust::Uncertain);
    EXPECT_EQ(beside("kurt3d", 1.0), 1U) << "better than none";
    enters(2, "kurt3d", 10.0, ScanTrust::Certain);
    enters(3, "kurt3d", 12.0, ScanTrust::Certain);
    enters(4, "kurt3d", 13.0, ScanTrust::Uncertain);
    EXPECT_EQ(beside("kurt3d", 9.0), 3U) << "the newest that counts, from which it is in sight";
    EXPECT_EQ(beside("kurt3d", 5.0), 2U) << "an older part of the map: the nearest";
    EXPECT_EQ(beside("crawler", 9.0), 2U) << "it has no scans: the nearest of others";
}

TEST(FindBook, TheOperatorsWordStandsAgainstLaterMeasurements) {
    Mission mission;
    const auto key = mission.file(seenAt(1.0));
    FindSample edited = mission.at(key);
    edited.heat = {SignState::Absent, "lamp", Unknown};
    mission.publish(edited);
    mission.file(seenAt(1.0));
    EXPECT_EQ(mission.at(key).heat.state, SignState::Absent);
    EXPECT_TRUE(std::isnan(mission.at(key).heat.value));
}

TEST(FindBook, NumbersAreNeverGivenTwiceNotEvenAfterUndo) {
    Mission mission;
    mission.file(seenAt(1.0));
    mission.publish(UndoSample{Now, "s", mission.sequence, "V1"});
    EXPECT_THAT(*mission.state.finds, SizeIs(0));
    EXPECT_EQ(mission.file(seenAt(1.0)).second, 2U);
}

TEST(FindBook, ADiscardedFindIsNotJoined) {
    Mission mission;
    const auto key = mission.file(seenAt(1.0));
    mission.publish(*withStatus(mission.state, key, Status::Discarded, "s", Now));
    EXPECT_EQ(mission.file(seenAt(1.0)).second, 2U);
}

TEST(FindBook, MergedFindsTellTogetherAndUndoTakesThemApart) {
    Mission mission;
    const auto one = mission.file(seenAt(1.0)), other = mission.file(seenAt(2.0));
    FindSample edited = mission.at(other);
    edited.tag = "R-17";
    edited.heat.value = 30.0;
    mission.publish(edited);
    mission.publish(*mergedInto(mission.state, other, one.second, "s", Now));
    const auto whole = *wholeFind(mission.state, one);
    EXPECT_EQ(whole.tag, "R-17");
    EXPECT_EQ(whole.heat.value, 33.0) << "its own word first";
    EXPECT_THAT(whole.evidence, SizeIs(2));
    EXPECT_EQ(mission.at(other).status, Status::Discarded);
    mission.publish(UndoSample{Now, "s", mission.sequence, "merge"});
    EXPECT_THAT(wholeFind(mission.state, one)->evidence, SizeIs(1));
    EXPECT_EQ(mission.at(other).status, Status::Hypothesis);
}

TEST(FindBook, TheNearestFindIsOfTheSameKindAndNotDiscarded) {
    Mission mission;
    const auto one = mission.file(seenAt(1.0)), other = mission.file(seenAt(2.0));
    const auto far = mission.file(seenAt(5.0));
    mission.file(seenAt(1.2), Kind::Hazard);
    EXPECT_EQ(nearestOfKind(mission.state, one)->find, other);
    EXPECT_DOUBLE_EQ(nearestOfKind(mission.state, one)->distance, 1.0);
    mission.publish(*withStatus(mission.state, other, Status::Discarded, "s", Now));
    EXPECT_EQ(nearestOfKind(mission.state, one)->find, far);
    EXPECT_GT(nearestOfKind(mission.state, one)->distance, MergeReach);
    EXPECT_FALSE(nearestOfKind(mission.state, {Kind::Hazard, 1U})) << "it is the only one of its kind";
    EXPECT_FALSE(nearestOfKind(mission.state, {Kind::Code, 1U})) << "nobody has filed it";
}

TEST(FindBook, NothingIsMergedIntoItselfNothingOrTheDiscarded) {
    Mission mission;
    const auto one = mission.file(seenAt(1.0)), other = mission.file(seenAt(2.0));
    EXPECT_FALSE(mergedInto(mission.state, one, one.second, "s", Now));
    EXPECT_FALSE(mergedInto(mission.state, one, 9, "s", Now));
    mission.publish(*withStatus(mission.state, other, Status::Discarded, "s", Now));
    EXPECT_FALSE(mergedInto(mission.state, one, other.second, "s", Now));
    EXPECT_FALSE(withStatus(mission.state, {Kind::Code, 1U}, Status::Confirmed, "s", Now));
}

TEST(FindBook, AFormThatIsOlderThanTheFindChangesOnlyItsFields) {
    Mission mission;
    const auto key = mission.file(seenAt(1.0));
    FindSample form = mission.at(key);  // as shown before it was confirmed
    form.situation = "void";
    mission.publish(*withStatus(mission.state, key, Status::Confirmed, "s", Now));
    mission.publish(*filledIn(mission.state, form, "s", Now));
    EXPECT_EQ(mission.at(key).status, Status::Confirmed);
    EXPECT_EQ(mission.at(key).situation, "void");
    form.number = 9;
    EXPECT_FALSE(filledIn(mission.state, form, "s", Now));
}

TEST(FindBook, AMovedFindStillMovesWithItsScan) {
    Mission mission;
    auto scan = std::make_shared<Scan>();
    scan->robot = "kurt3d";
    KeyScanSample key;
    key.id = 4;
    key.scan = scan;
    key.scanInMap = Pose(Eigen::Translation3d(1.0, 0.0, 0.0));
    mission.publish(key);
    FrozenEvidence frozen = seenAt(2.0);
    frozen.scan = 4;
    frozen.positionInScan = {1.0, 0.0, 0.3};
    const auto find = mission.file(frozen);
    mission.publish(*movedTo(mission.state, find, {5.0, 0.0, 0.0}, "s", Now));
    EXPECT_NEAR(positionInMap(mission.state, mission.at(find)).x(), 5.0, 1e-9);
    ScanPosesSample poses;
    poses.poses = {{.scan = 4, .scanInMap = Pose(Eigen::Translation3d(2.0, 0.0, 0.0))}};
    mission.publish(poses);
    EXPECT_NEAR(positionInMap(mission.state, mission.at(find)).x(), 6.0, 1e-9);
    EXPECT_FALSE(movedTo(mission.state, find, {NAN, 0.0, 0.0}, "s", Now));
}

TEST(FindBook, WhatIsMovedAlongTheFloorStaysAsHighAsItWas) {
    Mission mission;
    FrozenEvidence high = seenAt(1.0);
    high.positionInMap.z() = 0.8;
    const FindKey find = mission.file(high);
    EXPECT_EQ(movedTo(mission.state, find, {5.0, 1.0, 0.1}, "s", Now)->positionInMap,
              Eigen::Vector3d(5.0, 1.0, 0.8));
    const auto above = movedTo(mission.state, find, {5.0, 1.0, 3.0}, "s", Now)->positionInMap;
    EXPECT_NEAR(above.z(), 3.0 + LyingHeight, 1e-9) << "on another storey";
    const auto below = movedTo(mission.state, find, {5.0, 1.0, -3.0}, "s", Now)->positionInMap;
    EXPECT_NEAR(below.z(), -3.0 + LyingHeight, 1e-9);
    EXPECT_NEAR(aboveFloor({1.0, 2.0, 0.4}).z(), 0.4 + LyingHeight, 1e-9) << "new: as a body lies";
}

TEST(FindBook, ACandidateIsFiledWithItsCues) {
    Mission mission;
    ModeSample mode;
    mode.autonomous = true;
    mission.state.robots["kurt3d"].edit().mode = latestPtr(Latest<ModeSample>{1, Now, mode});
    CandidateSample candidate;
    candidate.id = 1;
    candidate.positionInMap = {3.0, 1.0, 0.2};
    candidate.cues = {
        {.kind = "heat", .robot = "kurt3d", .topic = "/kurt3d/ir", .sequence = 5, .value = 34.0},
        {.kind = "motion", .robot = "kurt3d", .topic = "/kurt3d/left", .sequence = 6},
        {.kind = "sighting", .robot = "kurt3d", .topic = "/kurt3d/sightings", .sequence = 7}};
    const auto sample = filedFrom(mission.state, candidate, "s", Now);
    EXPECT_EQ(sample.heat.value, 34.0);
    EXPECT_EQ(sample.motion.state, SignState::Present);
    EXPECT_EQ(sample.co2.state, SignState::Unknown);
    EXPECT_TRUE(sample.autonomous);
    ASSERT_THAT(sample.evidence, SizeIs(3));
    EXPECT_EQ(sample.evidence[2].kind, "sighting");
}

TEST(FindBook, ACandidateIsFiledWithTheScanThatItHangsOn) {
    Mission mission;
    KeyScanSample scan;
    scan.id = 9;
    scan.stamp = Now;
    mission.publish(scan);
    CandidateSample candidate;
    candidate.scan = 9;
    const auto sample = filedFrom(mission.state, candidate, "s", Now);
    ASSERT_THAT(sample.evidence, SizeIs(1));
    EXPECT_EQ(sample.evidence[0].kind, "scan");
    EXPECT_EQ(sample.evidence[0].sequence, mission.sequence) << "the event that has its points";
    FrozenEvidence seen;
    seen.evidence = {{"scan", "/kurt3d/points", 100, Now}};
    EXPECT_THAT(filedFrom(mission.state, candidate, "s", Now, seen).evidence, SizeIs(1)) << "the one frozen";
    candidate.scan = 8;
    EXPECT_THAT(filedFrom(mission.state, candidate, "s", Now).evidence, SizeIs(0)) << "not in the map";
}

CandidateSample codeAt(double x, const std::string& text, std::uint32_t id) {
    CandidateSample code;
    code.id = id;
    code.kind = Kind::Code;
    code.positionInMap = {x, 0.0, 0.5};
    code.confidence = 0.95;
    code.cues = {{.kind = "code", .robot = "kurt3d", .text = text}};
    return code;
}

TEST(FindBook, NeighbouringSignsThatSayDifferentThingsAreTwo) {
    Mission mission;
    const CandidateSample one = codeAt(1.0, "yellow-1", 1), other = codeAt(1.3, "yellow-2", 2);
    mission.publish(one);
    mission.publish(other);
    mission.publish(filedFrom(mission.state, one, "s", Now));
    EXPECT_TRUE(isFiled(mission.state, one));
    EXPECT_FALSE(isFiled(mission.state, other)) << "it stays on the list";
    mission.publish(filedFrom(mission.state, other, "s", Now));
    EXPECT_EQ(mission.at({Kind::Code, 1U}).tag, "yellow-1");
    ASSERT_TRUE(mission.state.finds->contains({Kind::Code, 2U}));
    EXPECT_EQ(mission.at({Kind::Code, 2U}).tag, "yellow-2");
    mission.publish(filedFrom(mission.state, codeAt(1.2, "yellow-1", 3), "s", Now));
    EXPECT_THAT(*mission.state.finds, SizeIs(2)) << "the same one, read once more";
    EXPECT_EQ(findNear(mission.state, Kind::Code, {1.2, 0.0, 0.5}), FindKey(Kind::Code, 2U))
        << "unread, it is the nearest";
}

TEST(FindBook, WhatLiesBesideADiscardedFindIsShownAndThatItselfIsNot) {
    Mission mission;
    const FindKey find = mission.file(seenAt(1.0));
    CandidateSample beside;
    beside.id = 3;
    beside.positionInMap = {1.5, 0.0, 0.3};
    EXPECT_TRUE(isFiled(mission.state, beside)) << "a part of it";
    mission.publish(*withStatus(mission.state, find, Status::Discarded, "s", Now));
    EXPECT_FALSE(isFiled(mission.state, beside));
    CandidateSample again = beside;
    again.positionInMap.x() = 1.2;
    EXPECT_TRUE(isFiled(mission.state, again));
    beside.victim = find.second;
    EXPECT_TRUE(isFiled(mission.state, beside)) << "it was filed as that";
}

TEST(FindBook, AVictimThatBearsTheTagOfAFiledOneIsThatOne) {
    Mission mission;
    FrozenEvidence frozen = seenAt(1.0);
    frozen.tag = "V-03";
    mission.file(frozen);
    CandidateSample feet;
    feet.positionInMap = {1.9, 0.0, 0.2};
    feet.cues = {{.kind = "code", .text = "yellow-1"}, {.kind = "tag", .text = "V-03"}};
    EXPECT_EQ(tagOf(feet), "V-03") << "its own, not a code beside it";
    EXPECT_TRUE(isFiled(mission.state, feet));
    feet.cues = {{.kind = "tag", .text = "V-04"}};
    EXPECT_FALSE(isFiled(mission.state, feet));
    EXPECT_EQ(filedFrom(mission.state, feet, "s", Now).tag, "V-04");
}

TEST(FindBook, WhatIsFrozenBetweenTwoSignsIsTheNearerOne) {
    Mission mission;
    mission.publish(codeAt(1.0, "yellow-1", 1));
    mission.publish(codeAt(1.3, "yellow-2", 2));
    const auto near = candidatesNear(mission.state, Kind::Code, {1.25, 0.0, 0.5});
    ASSERT_THAT(near, SizeIs(1)) << "the other one stays on the list";
    EXPECT_EQ(tagOf(near.front()), "yellow-2");
}

TEST(FindBook, WhatIsEditedOverAnOldFormLeavesWhatWasFilledInSince) {
    FindSample before, newest, after;
    before.heat.value = 33.0;
    newest = after = before;
    newest.tag = "V-02";
    newest.heat = {SignState::Present, "face", 34.0};
    newest.status = Status::Confirmed;
    after.situation = "trapped";
    after.sound.state = SignState::Absent;
    const FindSample whole = withEdits(newest, before, after);
    EXPECT_EQ(whole.situation, "trapped");
    EXPECT_EQ(whole.sound.state, SignState::Absent);
    EXPECT_EQ(whole.tag, "V-02");
    EXPECT_EQ(whole.heat.value, 34.0);
    EXPECT_EQ(whole.heat.text, "face");
    EXPECT_EQ(whole.status, Status::Confirmed);
}

TEST(FindBook, CandidatesBesideAPlaceAreThoseThatAreShownAndNoOtherFind) {
    Mission mission;
    const auto believe = [&](std::uint32_t id, double x, double confidence, std::uint32_t victim,
                             bool dismissed) {
        CandidateSample one;
        one.id = id;
        one.positionInMap = {x, 0.0, 0.3};
        one.confidence = confidence;
        one.victim = victim;
        one.dismissed = dismissed;
        mission.publish(one);
    };
    mission.file(seenAt(9.0));
    believe(1, 1.2, 0.8, 0, false);
    believe(2, 1.2, 0.3, 0, false);  // not shown
    believe(3, 1.2, 0.8, 0, true);   // none
    believe(4, 1.2, 0.8, 1, false);  // V1
    believe(5, 1.2, 0.8, 7, false);  // of a find that was taken back
    believe(6, 2.2, 0.8, 0, false);  // elsewhere
    std::vector<std::uint32_t> near;
    for (const CandidateSample& one : candidatesNear(mission.state, Kind::Victim, {1.0, 0.0, 0.3}))
        near.push_back(one.id);
    EXPECT_THAT(near, testing::ElementsAre(1U, 5U));
    EXPECT_THAT(candidatesNear(mission.state, Kind::Hazard, {1.0, 0.0, 0.3}), testing::IsEmpty());
}

}  // namespace
}  // namespace leitstand
