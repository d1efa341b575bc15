#include "core/mission/finds/find_moves.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/event/find_sample.h"
#include "core/event/map_samples.h"
#include "core/event/scan_pose.h"
#include "core/event/station_samples.h"
#include "core/mission/finds/find_book.h"
#include "core/mission/state/find_state.h"
#include "core/mission/state/fold.h"

namespace leitstand {
namespace {

using Kind = FindSample::Kind;
using Cause = FindMove::Cause;
using Said = ScanPosesSample::Cause;
using testing::IsEmpty;
using testing::SizeIs;

const FindKey V1{Kind::Victim, 1U};

Pose along(double x) {
    return Pose(Eigen::Translation3d(x, 0.0, 0.0));
}

/// A mission with a key scan at the origin and a victim that hangs on it, 2 m before it.
struct Mission {
    MissionState state;
    FindMoves moves;
    std::uint64_t sequence = 0;

    Mission() {
        KeyScanSample key;
        key.id = 4;
        key.scan = std::make_shared<const Scan>();
        publish(key);
        FrozenEvidence frozen;
        frozen.scan = 4;
        frozen.positionInScan = frozen.positionInMap = {2.0, 0.0, 0.3};
        publish(filed(state, Kind::Victim, frozen, "s", Time(std::chrono::seconds(1))));
    }
    void publish(const Sample& sample) {
        ++sequence;
        state = fold(std::move(state), {sequence, Time(std::chrono::seconds(sequence)), "", "/leitstand/x",
                                        std::nullopt, "", sample});
    }
    void put(double x, Said cause, ScanTrust trust = ScanTrust::Certain) {
        ScanPosesSample poses;
        poses.station = "s";
        poses.cause = cause;
        poses.poses = {{.scan = 4, .scanInMap = along(x), .trust = trust}};
        publish(poses);
    }
    void undo(std::uint64_t event) {
        publish(UndoSample{Time(std::chrono::seconds(sequence)), "s", event, "undo"});
    }
};

TEST(FindMoves, EachCauseIsToldWithTimeAndPlaces) {
    Mission mission;
    EXPECT_THAT(mission.moves.follow(mission.state), IsEmpty());
    const std::vector<std::pair<Said, Cause>> causes = {{Said::Registration, Cause::Registration},
                                                        {Said::LoopClosure, Cause::LoopClosure},
                                                        {Said::Operator, Cause::Operator}};
    double x = 0.0;
    for (const auto& [reported, cause] : causes) {
        mission.put(x + 0.3, reported);
        const auto moves = mission.moves.follow(mission.state);
        ASSERT_THAT(moves, SizeIs(1));
        EXPECT_EQ(moves[0].find, V1);
        EXPECT_EQ(moves[0].cause, cause);
        EXPECT_EQ(moves[0].sequence, mission.sequence);
        EXPECT_EQ(moves[0].at, Time(std::chrono::seconds(mission.sequence)));
        EXPECT_NEAR(moves[0].from.x(), 2.0 + x, 1e-9);
        EXPECT_NEAR(moves[0].to.x(), 2.3 + x, 1e-9);
        EXPECT_NEAR(moves[0].metres(), 0.3, 1e-9);
        x += 0.3;
    }
    EXPECT_THAT(mission.moves.all(), SizeIs(3));
}

TEST(FindMoves, AnUndoThatMovesAScanBackIsACause) {
    Mission mission;
    mission.put(0.3, Said::Operator);
    const std::uint64_t drag = mission.sequence;
    mission.undo(drag);
    const std::uint64_t undo = mission.sequence;
    mission.undo(undo);
    mission.moves.follow(mission.state);
    ASSERT_THAT(mission.moves.all(), SizeIs(3)) << "dragged, taken back, done again";
    EXPECT_EQ(mission.moves.all()[1].cause, Cause::Undo);
    EXPECT_EQ(mission.moves.all()[1].sequence, undo);
    EXPECT_NEAR(mission.moves.all()[1].to.x(), 2.0, 1e-9);
    EXPECT_NEAR(mission.moves.all()[2].to.x(), 2.3, 1e-9);
}

TEST(FindMoves, SmallMovesAddUpUntilTheyAreWorthTelling) {
    Mission mission;
    mission.put(0.04, Said::Registration);
    EXPECT_THAT(mission.moves.follow(mission.state), IsEmpty());
    mission.put(0.08, Said::Registration);
    const auto moves = mission.moves.follow(mission.state);
    ASSERT_THAT(moves, SizeIs(1));
    EXPECT_NEAR(moves[0].metres(), 0.08, 1e-9);
}

TEST(FindMoves, AScanThatIsSetAsideWhereItWasMovesNothing) {
    Mission mission;
    mission.put(0.0, Said::Operator, ScanTrust::SetAside);
    EXPECT_THAT(mission.moves.follow(mission.state), IsEmpty());
    mission.put(0.5, Said::Operator, ScanTrust::Certain);
    EXPECT_THAT(mission.moves.follow(mission.state), SizeIs(1));
}

TEST(FindMoves, WhatPeopleMoveOrFillInIsNoMoveWithAScan) {
    Mission mission;
    mission.publish(*movedTo(mission.state, V1, {5.0, 0.0, 0.3}, "s", Time(std::chrono::seconds(9))));
    mission.undo(mission.sequence);
    FindSample form = mission.state.finds->at(V1).victim;
    form.situation = "void";
    mission.put(0.03, Said::Registration);
    mission.publish(*filledIn(mission.state, form, "s", Time(std::chrono::seconds(10))));
    EXPECT_THAT(mission.moves.follow(mission.state), IsEmpty());
    mission.put(0.06, Said::Registration);
    EXPECT_THAT(mission.moves.follow(mission.state), SizeIs(1)) << "what came before the form counts too";
}

TEST(FindMoves, AnEarlierStateBeginsAnewAndTellsTheSameAgain) {
    Mission mission;
    mission.put(0.3, Said::Registration);
    const MissionState earlier = mission.state;
    mission.put(0.9, Said::LoopClosure);
    EXPECT_THAT(mission.moves.follow(mission.state), SizeIs(2));
    EXPECT_THAT(mission.moves.follow(mission.state), IsEmpty()) << "nothing twice";
    EXPECT_THAT(mission.moves.follow(earlier), SizeIs(1));
    EXPECT_EQ(mission.moves.newest(V1)->cause, Cause::Registration);
    EXPECT_EQ(mission.moves.newest({Kind::Hazard, 1U}), nullptr);
}

}  // namespace
}  // namespace leitstand
