#include "app/services/by_hand/map_by_hand.h"

#include <algorithm>
#include <cstddef>
#include <future>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/services/places/mission_map.h"
#include "app/services/recorded/review_log.h"
#include "core/event/station_topics.h"
#include "core/mission/loops/open_loops.h"
#include "core/mission/state/decision.h"
#include "core/mission/state/scan_state.h"
#include "core/mission/state/session_state.h"
#include "tests/app/review/written_room.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

using testing::HasSubstr;
using testing::SizeIs;

constexpr std::size_t Scans = DriftedPlaces, Drifted = DriftedFrom;

/// A mission whose map drifted.
class MapByHandTest : public testing::Test {
protected:
    void SetUp() override {
        WrittenMission mission(folder());
        writeDriftedRoom(mission, m_seconds);
        ask(mission);
    }
    virtual void ask(WrittenMission& /*mission*/) {}
    [[nodiscard]] std::filesystem::path folder() const { return m_folder / "mission"; }
    [[nodiscard]] MissionState state() const {
        const auto log = ReviewLog::open(folder()).value();
        return log->stateAt(log->last());
    }
    [[nodiscard]] std::vector<Pose> poses() const {
        std::vector<Pose> found;
        for (const ScanPose& pose : posesOf(state())) found.push_back(pose.scanInMap);
        return found;
    }
    /// How far the scan that is worst off lies from where it was taken, by the first one [m].
    [[nodiscard]] double error() const {
        const auto found = poses();
        double most = 0.0;
        for (std::size_t i = 0; i < found.size(); ++i) {
            const Pose right = found.front() * driftedPlace(0).inverse() * driftedPlace(static_cast<int>(i));
            most = std::max(most, distanceBetween(found[i], right));
        }
        return most;
    }
    [[nodiscard]] std::unique_ptr<MapByHand> hand(StationMappingListener listener = {}) const {
        auto opened = MapByHand::open(folder(), "map-by-hand-test", "test", std::move(listener));
        EXPECT_TRUE(opened) << opened.error().text;
        return std::move(opened).value();
    }
    const TemporaryFolder m_folder;
    double m_seconds = 1.0;
};

TEST_F(MapByHandTest, APartThatIsMovedIsWhereItBelongsInTheMissionAndIsTakenBackLater) {
    const auto before = poses();
    ASSERT_GT(error(), 0.45);
    {
        const auto open = hand();
        const LiveMapPtr map = open->mapping().scans();
        ASSERT_THAT(map->scans, SizeIs(Scans));
        const LiveKeyScan& first = map->scans[Drifted];
        const SubmapOnMap run(map, submapOf(*map, first.id, SubmapKind::FromHere));
        ASSERT_THAT(run.submap(), SizeIs(Scans - Drifted));
        const auto snapped = run.snapped(poseFrom({0.1, -0.35, 0}, 0, 0, degrees(3)));
        ASSERT_TRUE(snapped);
        std::promise<Result<std::size_t>> left;
        ASSERT_TRUE(
            open->mapping().moveTo(first.id, SubmapKind::FromHere, *snapped * first.pose.scanInMap,
                                   [&left](Result<std::size_t> links) { left.set_value(std::move(links)); }));
        const auto links = left.get_future().get();
        ASSERT_TRUE(links) << links.error().text;
        EXPECT_GE(*links, 3U);
        ASSERT_TRUE(open->close()) << "at once: the map follows before it ends";
        EXPECT_TRUE(open->decided());
    }
    EXPECT_LT(error(), 0.03);
    EXPECT_THAT(*state().keyScans, SizeIs(Scans)) << "what was recorded is there";
    for (const Link& link : linksOf(folder(), state()))
        EXPECT_LT(link.id, 2'000U) << "no other station has a part in it, whose numbers could be the same";
    {
        const auto open = hand();
        ASSERT_TRUE(open->mapping().undoable()) << "what somebody decided here earlier";
        ASSERT_TRUE(open->mapping().undo());
        ASSERT_TRUE(open->close());
    }
    const auto after = poses();
    for (std::size_t i = 0; i < before.size(); ++i)
        EXPECT_LT(distanceBetween(after[i], before[i]), 0.01) << i;
    const auto operators = [&] {
        const MissionState now = state();
        std::size_t active = 0;
        for (const Link& link : linksOf(folder(), now))
            active += link.active && link.kind == LinkKind::Operator ? 1 : 0;
        return active;
    };
    EXPECT_EQ(operators(), 0U) << "no link of it counts";
}

TEST_F(MapByHandTest, LookingAtAMapChangesNothing) {
    const auto before = poses();
    const std::size_t decisions = state().decisions->size();
    {
        const auto open = hand();
        EXPECT_FALSE(open->mapping().undoable()) << "what the mission decided is not taken back here";
        ASSERT_TRUE(open->close());
        EXPECT_FALSE(open->decided());
    }
    const auto after = poses();
    for (std::size_t i = 0; i < before.size(); ++i) EXPECT_EQ(after[i].matrix(), before[i].matrix()) << i;
    EXPECT_EQ(state().decisions->size(), decisions);
    EXPECT_EQ(state().sessions->size(), 1U) << "who looked is known";
}

TEST_F(MapByHandTest, AScanIsRejectedAndComesBack) {
    {
        const auto open = hand();
        ASSERT_TRUE(open->mapping().reject(7));
        ASSERT_FALSE(open->mapping().reject(77));
        ASSERT_TRUE(open->close());
    }
    EXPECT_EQ(state().keyScans->at(7).pose.trust, ScanTrust::SetAside);
    {
        const auto open = hand();
        ASSERT_TRUE(open->mapping().undo());
        ASSERT_TRUE(open->close());
    }
    EXPECT_EQ(state().keyScans->at(7).pose.trust, ScanTrust::Certain);
}

/// It ended with a question: scan 8 is 0.5 m from where a loop wants it.
class AskedByHandTest : public MapByHandTest {
protected:
    explicit AskedByHandTest(bool closed = false) : m_closed(closed) {}
    void ask(WrittenMission& mission) override {
        ScanLinksSample asked{WrittenMission::at(m_seconds), "us", {}};
        for (const auto& [from, to] : {std::pair(1, 6), std::pair(2, 8)}) {
            Link link;
            link.id = 900 + static_cast<std::uint64_t>(to);
            link.from = static_cast<std::uint64_t>(from);
            link.to = static_cast<std::uint64_t>(to);
            link.pose = driftedPlace(from - 1).inverse() * driftedPlace(to - 1);
            link.information = Information::Identity() * 1e4;
            link.kind = LinkKind::Loop;
            link.station = "us";
            link.active = m_closed;
            asked.links.push_back(link);
        }
        mission.publish(m_seconds, std::string(station_topic::ScanLinks), asked);
    }

    const bool m_closed;
};

/// It ended when a loop had closed, before scans moved.
class ClosedByHandTest : public AskedByHandTest {
protected:
    ClosedByHandTest() : AskedByHandTest(true) {}
};

TEST_F(ClosedByHandTest, LookingAtAMapChangesNothingWhateverItsLinksSay) {
    const auto before = poses();
    {
        const auto open = hand();
        ASSERT_TRUE(open->close());
        EXPECT_FALSE(open->decided());
    }
    const auto after = poses();
    for (std::size_t i = 0; i < before.size(); ++i) EXPECT_EQ(after[i].matrix(), before[i].matrix()) << i;
    {
        const auto open = hand();
        ASSERT_TRUE(open->mapping().undoLoop());
        ASSERT_TRUE(open->close());
        EXPECT_TRUE(open->decided());
    }
    for (const Link& link : linksOf(folder(), state()))
        EXPECT_FALSE(link.active && closesLoop(link.kind)) << link.id;
}

TEST_F(AskedByHandTest, WhatTheMissionLeftOpenIsAnswered) {
    ASSERT_TRUE(openLoop(state()));
    {
        const auto open = hand();
        const auto loop = openLoop(*open->state());
        ASSERT_TRUE(loop);
        ASSERT_TRUE(open->mapping().answerLoop(*loop, true));
        ASSERT_TRUE(open->close());
    }
    EXPECT_FALSE(openLoop(state()));
    EXPECT_LT(error(), 0.03);
}

TEST_F(AskedByHandTest, AnotherPlaceIsNotAskedAboutAgain) {
    const auto before = poses();
    {
        const auto open = hand();
        ASSERT_TRUE(open->mapping().answerLoop(*openLoop(*open->state()), false));
        ASSERT_TRUE(open->close());
    }
    EXPECT_FALSE(openLoop(state()));
    EXPECT_LT(distanceBetween(poses().back(), before.back()), 0.01);
}

TEST(MapsByHand, NeedAMapOfOurs) {
    const TemporaryFolder folder;
    const auto none = MapByHand::open(folder / "none", "map-by-hand-test", "test");
    ASSERT_FALSE(none);
    EXPECT_THAT(none.error().text, HasSubstr("none"));
    {
        WrittenMission mission(folder / "empty");
        mission.publish(1.0, std::string(station_topic::Notes),
                        NoteSample{WrittenMission::at(1.0), "us", "", "no scan"});
    }
    {
        WrittenMission mission(folder / "old");
        double seconds = 1.0;
        writeRoom(mission, alongTheRoom(), seconds, false);
    }
    const auto old = MapByHand::open(folder / "old", "map-by-hand-test", "test");
    ASSERT_FALSE(old);
    EXPECT_THAT(old.error().text, HasSubstr("tidy the map first"));
    const auto empty = MapByHand::open(folder / "empty", "map-by-hand-test", "test");
    ASSERT_FALSE(empty);
    EXPECT_THAT(empty.error().text, HasSubstr("found no key scans"));
}

}  // namespace
}  // namespace leitstand::test
