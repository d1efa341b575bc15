#include "core/mission/state/undo.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/event/map_samples.h"
#include "core/event/scan_links.h"
#include "core/event/scan_pose.h"
#include "core/mission/state/crop_state.h"
#include "core/mission/state/decision.h"
#include "core/mission/state/fold.h"
#include "core/mission/state/scan_state.h"
#include "tests/core/mission/event_stream.h"

namespace leitstand {
namespace {

using test::at;
using test::event;
using test::keyScan;
using Kind = MapDecision::Kind;

/// A mission of two scans, and what the operator does with them.
class UndoOnMap : public testing::Test {
protected:
    UndoOnMap() {
        add(keyScan(1, 0.0));
        add(keyScan(2, 1.0));
    }
    void add(Sample sample) { m_fold.add(event(++m_sequence, std::move(sample))); }
    void decide(std::vector<std::uint64_t> scans, ScanTrust trust, const std::string& station = "us") {
        ScanPosesSample made;
        made.station = station;
        made.cause = ScanPosesSample::Cause::Operator;
        for (const std::uint64_t scan : scans) made.poses.push_back({.scan = scan, .trust = trust});
        add(made);
    }
    [[nodiscard]] const MissionState& state() const { return m_fold.state(); }
    [[nodiscard]] bool takeBack() {
        const auto undo = undoOnMap(state(), "us", at(0));
        if (undo) add(*undo);
        return undo.has_value();
    }
    [[nodiscard]] bool doAgain() {
        const auto redo = redoOnMap(state(), "us", at(0));
        if (redo) add(*redo);
        return redo.has_value();
    }

    Fold m_fold;
    std::uint64_t m_sequence = 0;
};

TEST_F(UndoOnMap, NamesWhatItTakesBack) {
    EXPECT_FALSE(undoable(state(), "us").has_value());
    decide({2}, ScanTrust::Certain);
    decide({1, 2}, ScanTrust::SetAside);
    EXPECT_EQ(undoable(state(), "us")->kind, Kind::SetAside);
    EXPECT_EQ(undoable(state(), "us")->scans.size(), 2U);
    EXPECT_EQ(undoOnMap(state(), "us", at(0))->text, "undo what=set_aside scans=2");
    ASSERT_TRUE(takeBack());
    EXPECT_EQ(redoOnMap(state(), "us", at(0))->text, "redo what=set_aside scans=2");
    EXPECT_EQ(undoable(state(), "us")->kind, Kind::Taken);
    EXPECT_THAT(undoable(state(), "us")->scans, testing::ElementsAre(2));
    EXPECT_EQ(redoable(state(), "us")->kind, Kind::SetAside);
    decide({1}, ScanTrust::Uncertain);
    EXPECT_EQ(undoable(state(), "us")->kind, Kind::Tried);
    EXPECT_FALSE(redoable(state(), "us").has_value()) << "something was decided since";
}

TEST_F(UndoOnMap, TakesAreasAndScansBackInTheirOrderAndDoesThemAgain) {
    add(MapCropSample{.stamp = {}, .station = "us", .polygon = {{0.0, 0.0}, {4.0, 0.0}, {4.0, 3.0}}});
    decide({1}, ScanTrust::SetAside);
    add(MapCropSample{.stamp = {}, .station = "us", .polygon = {}, .ceiling = 2.0});
    EXPECT_EQ(undoable(state(), "us")->kind, Kind::Crop);
    ASSERT_TRUE(takeBack());
    EXPECT_EQ(state().crop->sample.polygon.size(), 3U);
    ASSERT_TRUE(takeBack());
    EXPECT_EQ(state().keyScans->at(1).pose.trust, ScanTrust::Certain);
    ASSERT_TRUE(takeBack());
    EXPECT_EQ(state().crop, nullptr);
    EXPECT_FALSE(takeBack());
    for (int i = 0; i < 3; ++i) ASSERT_TRUE(doAgain());
    EXPECT_FALSE(doAgain());
    EXPECT_EQ(state().crop->sample.ceiling, 2.0);
    EXPECT_EQ(state().keyScans->at(1).pose.trust, ScanTrust::SetAside);
}

TEST_F(UndoOnMap, LeavesOtherStationsAndRegistrationsAlone) {
    decide({1}, ScanTrust::SetAside, "them");
    add(MapCropSample{.stamp = {}, .station = "them", .polygon = {}, .ceiling = 2.0});
    add(test::moved(2, 1.5));
    EXPECT_FALSE(takeBack());
    EXPECT_TRUE(undoable(state(), "them").has_value());
}

TEST_F(UndoOnMap, AClosedLoopIsTakenBackApartFromDecisionsAndClosedAgain) {
    EXPECT_FALSE(lastLoop(state()).has_value());
    add(test::linked(7, LinkKind::Match));
    EXPECT_FALSE(lastLoop(state()).has_value())
        << "scans that were registered against each other are no loop";
    add(test::linked(8, LinkKind::Loop));
    decide({1}, ScanTrust::Uncertain);
    EXPECT_EQ(undoable(state(), "us")->kind, Kind::Tried) << "the operator's own act";
    EXPECT_TRUE(loopsOf(state()).front().active);
    const auto undo = undoLoop(state(), "us", at(0));
    ASSERT_TRUE(undo.has_value());
    EXPECT_EQ(undo->text, "undo what=loop");
    add(*undo);
    EXPECT_TRUE(state().loops->empty());
    ASSERT_EQ(loopsOf(state()).size(), 1U);
    EXPECT_FALSE(loopsOf(state()).front().active);
    EXPECT_FALSE(undoLoop(state(), "us", at(0)).has_value()) << "no other closed";
    EXPECT_EQ(redoable(state(), "us")->kind, Kind::Loop);
    ASSERT_TRUE(doAgain());
    EXPECT_TRUE(loopsOf(state()).front().active);
}

TEST_F(UndoOnMap, ALoopThatWasTakenOutIsNoneToTakeBack) {
    add(test::linked(8, LinkKind::Loop));
    add(test::linked(8, LinkKind::Loop, false));
    EXPECT_FALSE(loopsOf(state()).front().active);
    EXPECT_FALSE(lastLoop(state()).has_value());
    EXPECT_FALSE(undoLoop(state(), "us", at(0)).has_value());
}

TEST_F(UndoOnMap, AnAnswerOfTheOperatorIsTakenBackAsADecision) {
    ScanLinksSample answer = test::linked(8, LinkKind::Loop, false);
    add(answer);
    EXPECT_FALSE(undoable(state(), "us").has_value()) << "a question is nobody's act";
    answer.links.front().kind = LinkKind::Operator;
    add(answer);
    EXPECT_EQ(undoable(state(), "us")->kind, Kind::Refused);
    EXPECT_EQ(undoOnMap(state(), "us", at(0))->text, "undo what=refused_loop");
    ASSERT_TRUE(takeBack());
    answer.links.front().active = true;
    add(answer);
    EXPECT_EQ(undoable(state(), "us")->kind, Kind::Loop);
    ASSERT_TRUE(takeBack());
    ASSERT_EQ(loopsOf(state()).size(), 1U);
    EXPECT_FALSE(loopsOf(state()).front().active);
    EXPECT_EQ(loopsOf(state()).front().kind, LinkKind::Loop) << "the question is open again";
}

TEST_F(UndoOnMap, ADecisionFromBeforeALoopMovedTheScanIsTakenBackAndTheScanStaysThere) {
    decide({2}, ScanTrust::SetAside);
    ScanPosesSample closure = test::moved(2, 5.0);
    closure.cause = ScanPosesSample::Cause::LoopClosure;
    closure.poses.front().trust = ScanTrust::SetAside;  // as it was when the loop closed
    add(closure);
    ASSERT_TRUE(takeBack());
    const ScanPose& pose = state().keyScans->at(2).pose;
    EXPECT_EQ(pose.trust, ScanTrust::Certain);
    EXPECT_NEAR(pose.scanInMap.translation().x(), 5.0, 1e-9);
}

}  // namespace
}  // namespace leitstand
