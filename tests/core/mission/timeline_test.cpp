#include "core/mission/timeline/timeline_marks.h"

#include <chrono>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/event/candidate_sample.h"
#include "core/event/find_sample.h"
#include "core/event/map_samples.h"
#include "core/mission/state/fold.h"

namespace leitstand {
namespace {

using namespace std::chrono_literals;
using testing::IsEmpty;
using testing::SizeIs;

Event reported(std::uint64_t sequence, Sample sample) {
    Event event;
    event.sequence = sequence;
    event.received = Time(1'750'000'000s) + std::chrono::seconds(sequence);
    event.sample = std::move(sample);
    return event;
}

NoteSample note(const std::string& text) {
    NoteSample one;
    one.text = text;
    return one;
}

CandidateSample candidate(std::uint32_t id, double confidence) {
    CandidateSample one;
    one.id = id;
    one.confidence = confidence;
    one.cues = {{.kind = "heat", .robot = "kurt3d"}, {.kind = "motion"}, {.kind = "heat"}};
    return one;
}

TEST(TimelineCollector, ACandidateIsMarkedWhenItIsToldFirstAndWhenItIsDismissed) {
    TimelineCollector collector;
    collector.add(reported(1, candidate(7, 0.3)));
    EXPECT_THAT(collector.marks(), IsEmpty()) << "nobody would see it";
    collector.add(reported(2, candidate(7, 0.6)));
    collector.add(reported(3, candidate(7, 0.9)));
    collector.add(reported(4, candidate(7, 0.2)));
    CandidateSample none = candidate(7, 0.9);
    none.dismissed = true;
    collector.add(reported(5, none));
    collector.add(reported(6, none));
    collector.add(reported(7, candidate(7, 0.9)));
    const auto marks = collector.marks();
    ASSERT_THAT(marks, SizeIs(2));
    EXPECT_EQ(marks[0].kind, TimelineMark::Kind::Candidate);
    EXPECT_EQ(marks[0].key, "told");
    EXPECT_EQ(marks[0].name, "victim");
    EXPECT_EQ(marks[0].robot, "kurt3d");
    EXPECT_EQ(marks[0].text, "heat, motion");
    EXPECT_EQ(marks[0].candidate, 7U);
    EXPECT_EQ(marks[0].confidence, 0.6);
    EXPECT_EQ(marks[0].sequence, 2U);
    EXPECT_EQ(marks[1].key, "dismissed");
    EXPECT_EQ(marks[1].sequence, 5U);
}

TEST(TimelineCollector, WhatIsFiledOrDismissedWithoutBeingToldIsNoCandidate) {
    TimelineCollector collector;
    CandidateSample filed = candidate(1, 0.9);
    filed.victim = 2;
    collector.add(reported(1, filed));
    CandidateSample dismissed = candidate(2, 0.9);
    dismissed.dismissed = true;
    collector.add(reported(2, dismissed));
    EXPECT_THAT(collector.marks(), IsEmpty());
}

TEST(TimelineCollector, AFindThatMovesWithItsScanIsMarkedWithWhyAndHowFar) {
    TimelineCollector collector;
    std::uint64_t sequence = 0;
    const auto publish = [&](const Sample& sample) {
        ++sequence;
        collector.add(
            {sequence, Time(std::chrono::seconds(sequence)), "", "/leitstand/x", std::nullopt, "", sample});
    };
    KeyScanSample scan;
    scan.id = 3;
    scan.scan = std::make_shared<const Scan>();
    publish(scan);
    FindSample victim;
    victim.number = 1;
    victim.scan = 3;
    victim.positionInScan = {1.0, 0.0, 0.0};
    publish(victim);
    ScanPosesSample poses;
    poses.cause = ScanPosesSample::Cause::LoopClosure;
    poses.poses = {{.scan = 3, .scanInMap = Pose(Eigen::Translation3d(0.0, 0.3, 0.0))}};
    publish(poses);
    publish(UndoSample{Time{}, "s", sequence, "undo"});
    const auto marks = collector.marks();
    ASSERT_THAT(marks, SizeIs(4)) << "filed, moved, taken back and so moved again";
    EXPECT_EQ(marks[1].kind, TimelineMark::Kind::Moved);
    EXPECT_EQ(marks[1].key, "loop closure");
    EXPECT_EQ(marks[1].name, "V1");
    EXPECT_TRUE(marks[1].from.isApprox(Eigen::Vector3d(1.0, 0.0, 0.0)));
    EXPECT_TRUE(marks[1].to.isApprox(Eigen::Vector3d(1.0, 0.3, 0.0)));
    EXPECT_EQ(marks[1].sequence, 3U);
    const auto& back = marks[2].kind == TimelineMark::Kind::Moved ? marks[2] : marks[3];
    EXPECT_EQ(back.kind, TimelineMark::Kind::Moved);
    EXPECT_EQ(back.key, "undo");
    EXPECT_EQ(back.sequence, 4U);
}

TEST(TimelineCollector, AnUndoOfAnUndoDoesAgain) {
    TimelineCollector collector;
    const auto undo = [&](std::uint64_t sequence, std::uint64_t event, const char* text) {
        collector.add(reported(sequence, UndoSample{Time{}, "s", event, text}));
        return collector.marks().back();
    };
    collector.add(reported(1, note("door")));
    EXPECT_EQ(undo(2, 1, "undo: V1").key, "undo");
    const TimelineMark again = undo(3, 2, "redo: V1");
    EXPECT_EQ(again.key, "redo");
    EXPECT_EQ(again.text, "redo: V1");
    EXPECT_EQ(undo(4, 3, "").key, "undo") << "of what was done again";
    EXPECT_EQ(undo(5, 4, "").key, "redo");
    EXPECT_EQ(undo(6, 6, "").key, "undo") << "of itself: no more than that";
}

TEST(TimelineCollector, ANoteThatWasTakenBackIsNoMark) {
    TimelineCollector collector;
    MissionState mission;
    for (const Event& event : {reported(1, note("door")), reported(2, note("window")),
                               reported(3, UndoSample{Time{}, "s", 1, ""})}) {
        collector.add(event);
        mission = fold(std::move(mission), event);
    }
    auto marks = collector.marks();
    dropUndone(marks, mission);
    ASSERT_THAT(marks, SizeIs(2));
    EXPECT_EQ(marks[0].text, "window");
    EXPECT_EQ(marks[1].key, "undo");
    const auto kept = marks;
    dropUndone(marks, MissionState());
    EXPECT_THAT(marks, SizeIs(kept.size())) << "of a mission that knows nothing of them";
}

TEST(TimelineCollector, ACodeSaysWhatIsWrittenOnIt) {
    TimelineCollector collector;
    CandidateSample code = candidate(1, 0.95);
    code.kind = FindSample::Kind::Code;
    code.cues = {{.kind = "code", .robot = "crawler", .text = "exit 3"}};
    collector.add(reported(1, code));
    ASSERT_THAT(collector.marks(), SizeIs(1));
    EXPECT_EQ(collector.marks().front().name, "code");
    EXPECT_EQ(collector.marks().front().text, "exit 3");
}

}  // namespace
}  // namespace leitstand
