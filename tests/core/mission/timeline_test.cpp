#include "core/mission/timeline/timeline_marks.h"

#include <chrono>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace leitstand {
namespace {

using namespace std::chrono_literals;
using testing::IsEmpty;
using testing::SizeIs;

Event said(std::uint64_t sequence, const CandidateSample& candidate) {
    Event event;
    event.sequence = sequence;
    event.received = Time(1'750'000'000s) + std::chrono::seconds(sequence);
    event.sample = candidate;
    return event;
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
    collector.add(said(1, candidate(7, 0.3)));
    EXPECT_THAT(collector.marks(), IsEmpty()) << "nobody would see it";
    collector.add(said(2, candidate(7, 0.6)));
    collector.add(said(3, candidate(7, 0.9)));
    collector.add(said(4, candidate(7, 0.2)));
    CandidateSample none = candidate(7, 0.9);
    none.dismissed = true;
    collector.add(said(5, none));
    collector.add(said(6, none));
    collector.add(said(7, candidate(7, 0.9)));
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
    collector.add(said(1, filed));
    CandidateSample dismissed = candidate(2, 0.9);
    dismissed.dismissed = true;
    collector.add(said(2, dismissed));
    EXPECT_THAT(collector.marks(), IsEmpty());
}

TEST(TimelineCollector, AFindThatMovesWithItsScanIsMarkedWithWhyAndHowFar) {
    TimelineCollector collector;
    std::uint64_t sequence = 0;
    const auto say = [&](const Sample& sample) {
        ++sequence;
        collector.add(
            {sequence, Time(std::chrono::seconds(sequence)), "", "/leitstand/x", std::nullopt, "", sample});
    };
    KeyScanSample scan;
    scan.id = 3;
    scan.scan = std::make_shared<const Scan>();
    say(scan);
    VictimSample victim;
    victim.number = 1;
    victim.scan = 3;
    victim.positionInScan = {1.0, 0.0, 0.0};
    say(victim);
    ScanPosesSample poses;
    poses.cause = ScanPosesSample::Cause::LoopClosure;
    poses.poses = {{.scan = 3, .scanInMap = Pose(Eigen::Translation3d(0.0, 0.3, 0.0))}};
    say(poses);
    say(UndoSample{Time{}, "s", sequence, "undo"});
    const auto marks = collector.marks();
    ASSERT_THAT(marks, SizeIs(4)) << "filed, moved, taken back and so moved again";
    EXPECT_EQ(marks[1].kind, TimelineMark::Kind::Moved);
    EXPECT_EQ(marks[1].key, "loop closure");
    EXPECT_EQ(marks[1].name, "V1");
    EXPECT_EQ(marks[1].text, "1.00 0.00 0.00 → 1.00 0.30 0.00");
    EXPECT_NEAR(marks[1].metres, 0.3, 1e-9);
    EXPECT_EQ(marks[1].sequence, 3U);
    const auto& back = marks[2].kind == TimelineMark::Kind::Moved ? marks[2] : marks[3];
    EXPECT_EQ(back.kind, TimelineMark::Kind::Moved);
    EXPECT_EQ(back.key, "undo");
    EXPECT_EQ(back.sequence, 4U);
}

TEST(TimelineCollector, ACodeSaysWhatIsWrittenOnIt) {
    TimelineCollector collector;
    CandidateSample code = candidate(1, 0.95);
    code.kind = VictimSample::Kind::Code;
    code.cues = {{.kind = "code", .robot = "crawler", .text = "exit 3"}};
    collector.add(said(1, code));
    ASSERT_THAT(collector.marks(), SizeIs(1));
    EXPECT_EQ(collector.marks().front().name, "code");
    EXPECT_EQ(collector.marks().front().text, "exit 3");
}

}  // namespace
}  // namespace leitstand
