#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "app/services/finds/find_desk.h"
#include "app/services/victims/victim_watch.h"
#include "core/event/picture_samples.h"
#include "robots/simulation/arena/arena_generator.h"
#include "robots/simulation/arena/reachable_floor.h"
#include "tests/simulation/drives/exploration.h"
#include "tests/simulation/victims/search_drive.h"
#include "tests/support/wait.h"

namespace leitstand::simulation::test {
namespace {

constexpr std::chrono::seconds Patience(60);

/// Kurt3D explores by itself and looks at what it finds.
SearchResult searchYellow(std::uint64_t seed, double seconds) {
    DriveSetup setup;
    setup.seed = seed;
    SearchDrive drive(generateArena(Grade::Yellow, seed), setup);
    SeenFloor floor(*drive.driven.world);
    const Exploration result = explore(drive.driven, floor, seconds);
    return judge(drive, "yellow " + std::to_string(seed) + ", " +
                            std::to_string(static_cast<int>(result.seconds)) + " s");
}

/// Kurt3D as near as it comes to somebody who is not warm, does not breathe and does not move.
class LookAtAColdVictim : public testing::TestWithParam<std::uint64_t> {};

TEST_P(LookAtAColdVictim, ItIsFoundByItsTag) {
    const Arena arena = generateArena(Grade::Yellow, GetParam());
    const auto victim = std::find_if(arena.elements.begin(), arena.elements.end(), [](const Element& one) {
        return one.victim && one.victim->temperature < 28.0 && !one.victim->hidden;
    });
    ASSERT_NE(victim, arena.elements.end());
    DriveSetup setup;
    setup.seed = GetParam();
    // Its tag stands before its middle. Nearer, the scanner looks over it, and nothing tells how far it is.
    const Eigen::Vector2d place = placeBefore(*victim, 0.62);
    const double length = victim->size.x();
    const Eigen::Vector3d tag = victim->pose * Eigen::Vector3d(0.16 * length, -0.2 * length, 0.06);
    const Eigen::Vector2d towards = tag.head<2>() - place;
    setup.start = poseFrom({place.x(), place.y(), 0.0}, 0.0, 0.0, std::atan2(towards.y(), towards.x()));
    SearchDrive drive(arena, setup);
    drive.driven.hardware->setPanTilt("left", 0.0, degrees(30));
    drive.driven.pass(9.0);
    const SearchResult result = judge(drive, "a look at the tag of a cold victim");
    EXPECT_EQ(result.coldLookedAt, 1);
    EXPECT_EQ(result.coldFound, 1);
    EXPECT_LE(result.worst, 0.2);
    EXPECT_EQ(result.falseEver, 0);
}

// One lies open, one is partly covered.
INSTANTIATE_TEST_SUITE_P(Yellow, LookAtAColdVictim, testing::Values(1U, 9U, 10U));

/// Kurt3D stands before the first victim of a yellow arena and looks at it.
class LookAtAVictim : public testing::Test {
protected:
    LookAtAVictim() : m_arena(generateArena(Grade::Yellow, 2)) {
        m_victim = *std::find_if(m_arena.elements.begin(), m_arena.elements.end(),
                                 [](const Element& one) { return one.victim.has_value(); });
        DriveSetup setup;
        setup.seed = 2;
        const Eigen::Vector2d place = placeBefore(m_victim, 0.95);
        const Eigen::Vector2d towards = m_victim.pose.translation().head<2>() - place;
        setup.start = poseFrom({place.x(), place.y(), 0.0}, 0.0, 0.0, std::atan2(towards.y(), towards.x()));
        m_drive = std::make_unique<SearchDrive>(m_arena, setup);
        m_drive->onEvent = [this](const Event& event) { m_log.push_back(event); };
        m_drive->driven.hardware->setPanTilt("right", 0.0, degrees(16));
        m_drive->driven.hardware->setPanTilt("left", 0.0, degrees(16));
        m_drive->driven.pass(9.0);
    }

    Arena m_arena;
    Element m_victim;
    std::unique_ptr<SearchDrive> m_drive;
    std::vector<Event> m_log;
};

TEST_F(LookAtAVictim, ItIsFoundWhereItLies) {
    const SearchResult result = judge(*m_drive, "a look at a victim");
    EXPECT_EQ(result.lookedAt, 1);
    EXPECT_EQ(result.found, 1);
    EXPECT_LE(result.worst, 0.2);
    EXPECT_EQ(result.falseOnes, 0);

    // The same from the log, on the watch's thread.
    std::mutex mutex;
    std::map<std::uint32_t, CandidateSample> reported;
    VictimWatchSetup setup;
    setup.robots = {shippedRobot("kurt3d")};
    setup.station = "us";
    setup.onCandidate = [&](const CandidateSample& one) {
        const std::lock_guard lock(mutex);
        reported[one.id] = one;
    };
    VictimWatch watch(std::move(setup));
    for (const Event& event : m_log) {
        watch.onEvent(event);
        // A log comes faster than it can be worked through; pictures would be left out.
        if (event.sample.is<PictureSample>()) {
            ASSERT_TRUE(leitstand::test::waitUntil([&] { return watch.waiting() < 20; }, Patience));
        }
    }
    ASSERT_TRUE(leitstand::test::waitUntil(
        [&] {
            const std::lock_guard lock(mutex);
            return std::any_of(reported.begin(), reported.end(), [&](const auto& one) {
                const Eigen::Vector3d place = m_drive->mapInArena() * one.second.positionInMap;
                return one.second.kind == FindSample::Kind::Victim && fromBody(m_victim, place) < 0.2;
            });
        },
        Patience));
    watch.close();
    std::printf("the watch's thread took %.0f ms for 9 s\n",
                1e-6 * static_cast<double>(watch.worked().count()));
}

TEST_F(LookAtAVictim, AStationWithoutTheMapSaysNothing) {
    int reported = 0;
    VictimWatchSetup setup;
    setup.robots = {shippedRobot("kurt3d")};
    setup.station = "us";
    setup.maySearch = [] { return false; };
    setup.onCandidate = [&](const CandidateSample&) { ++reported; };
    VictimWatch watch(std::move(setup));
    for (const Event& event : m_log) watch.onEvent(event);
    ASSERT_TRUE(leitstand::test::waitUntil([&] { return watch.waiting() == 0; }, Patience));
    watch.close();
    EXPECT_EQ(reported, 0);
}

TEST_F(LookAtAVictim, WhatIsFrozenWithoutPointingIsWhereItsWarmthIs) {
    VictimWatchSetup placing;
    placing.robots = {shippedRobot("kurt3d")};
    placing.station = "us";
    placing.maySearch = [] { return false; };  // what the operator files is placed all the same
    placing.onCandidate = [](const CandidateSample&) {};
    VictimWatch watch(std::move(placing));
    std::vector<FindSample> filed;
    FindDeskSetup setup;
    setup.robots = {shippedRobot("kurt3d")};
    setup.station = "us";
    setup.mission = [] { return std::make_shared<const MissionState>(); };
    setup.record = [&](const FindSample& find) {
        filed.push_back(find);
        return Result<void>();
    };
    setup.locate = [&](const ChosenEvidence& chosen, FindDeskSetup::Located answer) {
        watch.locate({*chosen.picture, chosen.pixel, chosen.width, chosen.height, chosen.halfAngle},
                     [answer = std::move(answer)](const std::optional<PlacedCue>& cue) {
                         if (!cue) return answer(std::nullopt);
                         answer(PlacedFind{cue->scan, cue->inMap, std::sqrt(cue->covariance.trace() / 3.0)});
                     });
    };
    setup.robotInMap = [](const std::string&) { return std::nullopt; };
    setup.notify = [](const std::string& text) { std::printf("  %s\n", text.c_str()); };
    setup.now = [this] { return m_log.back().received; };
    FindDesk desk(std::move(setup));
    for (const Event& event : m_log) {
        watch.onEvent(event);
        desk.onEvent(event);
    }
    ASSERT_TRUE(leitstand::test::waitUntil([&] { return watch.waiting() == 0; }, Patience));
    desk.freeze("kurt3d", FindSample::Kind::Victim, "left");
    desk.finish();
    watch.close();
    ASSERT_EQ(filed.size(), 1U) << "its place was not found";
    EXPECT_EQ(filed[0].heat.state, VictimSign::State::Present);
    const Eigen::Vector3d place = m_drive->mapInArena() * filed[0].positionInMap;
    EXPECT_LT(fromBody(m_victim, place), 0.2) << "at " << place.transpose();
    const double height = (m_victim.pose.inverse() * place).z();
    EXPECT_GT(height, -0.2);
    EXPECT_LT(height, m_victim.size.z() + 0.2);
}

class VictimSearchLong : public testing::TestWithParam<std::uint64_t> {};

TEST_P(VictimSearchLong, AYellowArenaAgainstTheTruth) {
    const SearchResult result = searchYellow(GetParam(), 420.0);
    EXPECT_GE(result.lookedAt, 2);
    EXPECT_EQ(result.found, result.lookedAt);
    EXPECT_LE(result.worst, 0.2);
    EXPECT_LE(result.falseOnes, 1);
    EXPECT_LE(result.falseEver, 1) << "also of those that were taken back";
    EXPECT_EQ(result.codesWrong, 0);
    EXPECT_EQ(result.hazardsWrong, 0);
}

// The fourth was used for nothing before.
INSTANTIATE_TEST_SUITE_P(Yellow, VictimSearchLong, testing::Values(1U, 2U, 3U, 4U));

}  // namespace
}  // namespace leitstand::simulation::test
