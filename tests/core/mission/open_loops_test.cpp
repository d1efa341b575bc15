#include "core/mission/loops/open_loops.h"

#include <gtest/gtest.h>

#include "core/event/map_samples.h"
#include "core/mission/state/fold.h"
#include "core/mission/state/scan_state.h"
#include "tests/core/mission/event_stream.h"

namespace leitstand {
namespace {

using test::at;
using test::event;
using test::keyScan;
using test::linked;

/// A mission of two scans.
class OpenLoops : public testing::Test {
protected:
    OpenLoops() {
        add(keyScan(1, 0.0));
        add(keyScan(2, 1.0));
    }
    void add(Sample sample) { m_fold.add(event(++m_sequence, std::move(sample))); }
    [[nodiscard]] std::optional<OpenLoop> open() const { return openLoop(m_fold.state()); }

    Fold m_fold;
    std::uint64_t m_sequence = 0;
};

TEST_F(OpenLoops, OnlyWhatNobodyAnsweredIsAskedAndTellsTheSeam) {
    EXPECT_FALSE(open());
    add(linked(3, LinkKind::Match, false));
    add(linked(4, LinkKind::Loop));
    EXPECT_FALSE(open()) << "it closed by itself";
    add(linked(5, LinkKind::Loop, false));
    ASSERT_TRUE(open());
    EXPECT_EQ(open()->event, m_sequence);
    ASSERT_EQ(open()->links.size(), 1U);
    EXPECT_EQ(open()->links.front().id, 5U);
    EXPECT_NEAR(open()->seam(), 0.5, 1e-9) << "the scan is at 1 m, the link wants it at 0.5 m";
}

TEST_F(OpenLoops, AnAnswerEndsTheQuestionAndTakenBackItIsAskedAgain) {
    add(linked(5, LinkKind::Loop, false));
    for (const bool same : {true, false}) {
        ASSERT_TRUE(open());
        const ScanLinksSample answer = answerTo(*open(), same, "us", at(9));
        EXPECT_EQ(answer.station, "us");
        EXPECT_EQ(answer.links.front().kind, LinkKind::Operator);
        EXPECT_EQ(answer.links.front().active, same);
        add(answer);
        EXPECT_FALSE(open()) << same;
        add(test::undo(m_sequence));
    }
    EXPECT_TRUE(open());
}

TEST_F(OpenLoops, TheNewestQuestionComesFirstAndScansThatAreNotThereAskNothing) {
    add(linked(5, LinkKind::Loop, false));
    add(linked(6, LinkKind::Loop, false));
    ASSERT_TRUE(open());
    EXPECT_EQ(open()->links.front().id, 6U);
    ScanLinksSample far = linked(7, LinkKind::Loop, false);
    far.links.front().to = 99;
    add(far);
    EXPECT_EQ(open()->links.front().id, 6U);
}

TEST_F(OpenLoops, APlaceThatWasBroughtTogetherSinceIsNotAskedAboutAnyMore) {
    ScanLinksSample asked = linked(5, LinkKind::Loop, false);
    Link& link = asked.links.front();
    const Pose from = m_fold.state().keyScans->at(1).pose.scanInMap;
    const auto off = [&](double metres) {
        const Pose to = m_fold.state().keyScans->at(2).pose.scanInMap;
        return from.inverse() * to * poseFrom({metres, 0, 0}, 0, 0, 0);
    };
    link.pose = off(0.03);
    add(asked);
    EXPECT_TRUE(open()) << "it was asked, however little it moves";
    add(linked(6, LinkKind::Loop));
    EXPECT_TRUE(open()) << "a loop closed, and nothing moved yet";
    add(answerTo(*open(), false, "us", at(9)));
    EXPECT_FALSE(open());

    link.id = 7;
    link.pose = off(0.5);
    add(asked);
    EXPECT_TRUE(open());
    const Pose would = from * link.pose;
    const auto moves = [&](double away) {
        ScanPosesSample sample = test::moved(2, 0.0);
        sample.poses.front().scanInMap = would * poseFrom({away, 0, 0}, 0, 0, 0);
        add(sample);
    };
    moves(0.2);
    EXPECT_TRUE(open()) << "it is 20 cm off still";
    moves(0.04);
    EXPECT_FALSE(open()) << "another loop brought it there";
    add(test::undo(m_sequence));
    EXPECT_TRUE(open()) << "that is taken back";
}

}  // namespace
}  // namespace leitstand
