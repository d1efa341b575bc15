#include "widgets/models/victims/victim_rows.h"

#include <QSignalSpy>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/event/candidate_sample.h"
#include "core/event/find_sample.h"
#include "core/event/map_samples.h"
#include "core/mission/state/find_state.h"
#include "core/mission/state/fold.h"
#include "widgets/models/times.h"
#include "widgets/models/victims/move_text.h"
#include "widgets/models/victims/victim_list_model.h"

namespace leitstand {
namespace {

using Kind = FindSample::Kind;
using Status = FindSample::Status;
using testing::SizeIs;

void file(MissionState& state, Kind kind, std::uint32_t number, double x, Status status) {
    FindSample find;
    find.kind = kind;
    find.number = number;
    find.status = status;
    find.positionInMap = {x, 0.0, 0.3};
    find.heat = {VictimSign::State::Present, "face", 33.4};
    find.sound.state = VictimSign::State::Absent;
    find.situation = "void";
    state.finds.edit()[{kind, number}] = {number, number, find};
}

void believe(MissionState& state, std::uint32_t id, double x, double confidence) {
    CandidateSample candidate;
    candidate.id = id;
    candidate.positionInMap = {x, 0.0, 0.3};
    candidate.confidence = confidence;
    candidate.cues = {{.kind = "heat", .value = 32.6}, {.kind = "motion"}};
    state.candidates.edit()[id] = {.sequence = id, .first = id, .firstReport = {}, .candidate = candidate};
}

TEST(VictimRows, TellDistanceAndBearingFromTheRobot) {
    MissionState state;
    file(state, Kind::Victim, 1, 4.0, Status::Confirmed);
    const Pose facingBack(Eigen::Translation3d(4.0, -2.0, 0.0) *
                          Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitZ()));
    const auto rows = victimRows(state, facingBack);
    ASSERT_THAT(rows, SizeIs(1));
    EXPECT_EQ(rows[0].where.toStdString(), "2.0 m, 90° right");
    EXPECT_EQ(victimRows(state, Pose(Pose::Identity()))[0].where.toStdString(), "4.0 m, ahead");
    EXPECT_TRUE(victimRows(state, std::nullopt)[0].where.isEmpty());
}

TEST(VictimRows, SayWhatIsKnownAndWhatIsNot) {
    MissionState state;
    file(state, Kind::Victim, 1, 4.0, Status::Hypothesis);
    const auto rows = victimRows(state, std::nullopt);
    EXPECT_EQ(rows[0].name, QStringLiteral("V1"));
    EXPECT_EQ(rows[0].state, QStringLiteral("unconfirmed"));
    EXPECT_EQ(rows[0].tone, Tone::Attention);
    EXPECT_EQ(rows[0].signs.toStdString(), "heat 33 °C face · no sound · void");
    EXPECT_EQ(victimsTitle(rows).toStdString(), "1 victim, 1 not confirmed");
}

TEST(VictimRows, CandidatesComeAfterFindsTheSurestFirstUntilTheyAreFiledOrDismissed) {
    MissionState state;
    file(state, Kind::Victim, 1, 0.0, Status::Confirmed);
    file(state, Kind::Hazard, 1, 9.0, Status::Discarded);
    believe(state, 1, 3.0, 0.6);
    believe(state, 2, 5.0, 0.9);
    believe(state, 3, 0.2, 0.9);  // that is V1
    believe(state, 4, 7.0, 0.3);  // not sure enough
    believe(state, 5, 8.0, 0.9);
    state.candidates.edit().at(5).candidate.dismissed = true;
    const auto rows = victimRows(state, std::nullopt);
    ASSERT_THAT(rows, SizeIs(3));
    EXPECT_TRUE(rows[0].filed());
    EXPECT_EQ(rows[1].candidate, 2U);
    EXPECT_EQ(rows[1].name, "V?");
    EXPECT_EQ(rows[1].state.toStdString(), "candidate 90\u202f%");
    EXPECT_EQ(rows[1].signs.toStdString(), "heat 33 °C · motion");
    EXPECT_EQ(rows[2].candidate, 1U);
    EXPECT_EQ(victimsTitle(rows).toStdString(), "1 victim · 2 candidates");
}

TEST(VictimRows, ACandidateIsNotShownBesideWhatWasFiledThereAlsoWhenThatWasDiscardedSince) {
    MissionState state;
    file(state, Kind::Victim, 1, 0.0, Status::Discarded);
    believe(state, 1, 0.3, 0.9);  // that was V1
    believe(state, 2, 5.0, 0.9);  // filed as V2 from there, which the operator moved
    file(state, Kind::Victim, 2, 8.0, Status::Confirmed);
    state.candidates.edit().at(2).candidate.victim = 2;
    const auto rows = victimRows(state, std::nullopt);
    ASSERT_THAT(rows, SizeIs(1));
    EXPECT_EQ(rows[0].name, QStringLiteral("V2"));
    state.finds.edit().erase({Kind::Victim, 2U});  // undone
    const auto undone = victimRows(state, std::nullopt);
    ASSERT_THAT(undone, SizeIs(1));
    EXPECT_EQ(undone[0].candidate, 2U);
}

TEST(VictimRows, AReviewListsAllThatWasFiled) {
    MissionState state;
    file(state, Kind::Victim, 1, 0.0, Status::Confirmed);
    file(state, Kind::Victim, 2, 3.0, Status::Discarded);
    state.finds.edit().at({Kind::Victim, 2}).victim.mergedInto = 1;
    file(state, Kind::Hazard, 1, 9.0, Status::Discarded);
    state.finds.edit().at({Kind::Hazard, 1}).victim.text = "behind the door";
    believe(state, 1, 6.0, 0.9);
    const auto rows = filedRows(state);
    ASSERT_THAT(rows, SizeIs(3));
    EXPECT_EQ(rows[1].state.toStdString(), "part of V1");
    EXPECT_EQ(rows[2].state.toStdString(), "discarded");
    EXPECT_EQ(rows[2].tone, Tone::Muted);
    EXPECT_EQ(rows[2].signs.toStdString(), "behind the door");
    EXPECT_FALSE(rows[0].since.isEmpty() || rows[0].place.isEmpty());
    EXPECT_EQ(victimsTitle(rows).toStdString(), "1 victim · 2 discarded");
}

TEST(VictimRows, TellWhenAndWhyAFindMovedWithItsScan) {
    MissionState state;
    std::uint64_t sequence = 0;
    const auto publish = [&](const Sample& sample) {
        ++sequence;
        state = fold(std::move(state), {sequence, Time(std::chrono::seconds(sequence)), "", "/leitstand/x",
                                        std::nullopt, "", sample});
    };
    KeyScanSample scan;
    scan.id = 3;
    scan.scan = std::make_shared<const Scan>();
    publish(scan);
    FindSample victim;
    victim.number = 1;
    victim.scan = 3;
    publish(victim);
    FindMoves moves;
    moves.follow(state);
    EXPECT_TRUE(filedRows(state, &moves)[0].moved.isEmpty());
    ScanPosesSample poses;
    poses.cause = ScanPosesSample::Cause::Registration;
    poses.poses = {{.scan = 3, .scanInMap = Pose(Eigen::Translation3d(0.0, 0.32, 0.0))}};
    publish(poses);
    const auto reported = moves.follow(state);
    EXPECT_EQ(movesText(reported).toStdString(), "V1 0.32 m moved, since scans were registered again");
    EXPECT_TRUE(movesText({}).isEmpty());
    const QString moved = filedRows(state, &moves)[0].moved;
    EXPECT_EQ(moved, QStringLiteral("moved 0.32 m at %1, since scans were registered again")
                         .arg(wallText(Time(std::chrono::seconds(3)))));
    VictimListModel model;
    model.setRows(victimRows(state, std::nullopt, &moves));
    EXPECT_TRUE(model.index(0, 0).data(Qt::ToolTipRole).toString().contains(moved));
}

TEST(VictimRows, TheListKeepsItsRowsWhileNumbersChange) {
    MissionState state;
    file(state, Kind::Victim, 1, 4.0, Status::Hypothesis);
    VictimListModel model;
    QSignalSpy reset(&model, &QAbstractItemModel::modelReset);
    QSignalSpy changed(&model, &QAbstractItemModel::dataChanged);
    model.setRows(victimRows(state, Pose(Pose::Identity())));
    EXPECT_EQ(reset.count(), 1);
    model.setRows(victimRows(state, Pose(Eigen::Translation3d(1.0, 0.0, 0.0))));
    EXPECT_EQ(reset.count(), 1);
    EXPECT_EQ(changed.count(), 1);
    EXPECT_EQ(model.rowOf({Kind::Victim, 1U}), 0);
    EXPECT_EQ(model.rowOf({Kind::Code, 1U}), -1);
    EXPECT_EQ(model.row(1), nullptr);
}

}  // namespace
}  // namespace leitstand
