#include "app/services/recorded/review_opening.h"

#include <gtest/gtest.h>

#include "app/services/recorded/review_cadence.h"
#include "app/services/recorded/review_log.h"
#include "app/services/review/playing/review_player.h"
#include "core/event/status_samples.h"
#include "core/event/stream_role.h"
#include "tests/app/review/written_mission.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/wait.h"

namespace leitstand::test {
namespace {

using Mission = WrittenMission;
using namespace std::chrono_literals;

/// Forty seconds of a robot whose camera is switched on after 4 s, whose map begins after 6 s; pictures every
/// 3 s, as a thinned mission keeps them, and two slices of its scanner, as evidence.
class ReviewOpeningTest : public testing::Test {
protected:
    ReviewOpeningTest() {
        Mission mission(m_mission);
        for (int i = 0; i <= 400; ++i) {
            const double t = 0.1 * i;
            if (i == 90 || i == 200) {
                mission.sayPlace(t, 0.01 * i);
            } else {
                mission.sayOdometry(t, 0.01 * i);
            }
            if (i >= 40 && (i - 40) % 30 == 0) mission.sayPicture(t, 100);
            if (i >= 60 && i % 20 == 0) mission.sayKeyScan(t, static_cast<std::uint64_t>(i / 20), 0.01 * i);
            if (i == 330) {
                GasSample gas;  // from a sensor that was switched on late: nobody waits for it
                gas.gas = "co2";
                gas.ppm = 500.0;
                if (const auto* stream = Mission::robot().stream(StreamRole::Gas))
                    mission.publish(t, stream->topic, gas);
            }
        }
    }
    const TemporaryFolder m_folder;
    const std::filesystem::path m_mission = m_folder / "mission";
};

TEST_F(ReviewOpeningTest, AReviewOpensWhereItsPanesHaveSomething) {
    const auto player = ReviewPlayer::open(m_mission).value();
    ASSERT_TRUE(waitUntil([&] { return player->moment() != nullptr; }, 60s));
    const ReviewMomentPtr moment = player->moment();
    const double opened = std::chrono::duration<double>(moment->now - Mission::begin()).count();
    EXPECT_GE(opened, 6.0) << "the map has begun";
    EXPECT_LT(opened, 6.5) << "and nobody waits for what came long after";
    EXPECT_FALSE(moment->pictures.empty());
    EXPECT_FALSE(moment->map->scans.empty());
    EXPECT_EQ(player->position(), moment->now) << "the slider says so";
}

TEST_F(ReviewOpeningTest, WhoeverSeeksBeforeItIsReadGoesThere) {
    const auto player = ReviewPlayer::open(m_mission).value();
    player->seek(Mission::at(20.0));
    // A log that is read before the seek is heard shows its beginning first.
    EXPECT_TRUE(waitUntil(
        [&] {
            const auto moment = player->moment();
            return moment != nullptr && moment->now == Mission::at(20.0);
        },
        60s));
}

TEST_F(ReviewOpeningTest, HowOftenStreamsCameIsKnown) {
    const auto log = ReviewLog::open(m_mission).value();
    const ReviewIndexPtr index = indexOf(*log);
    const std::string pictures = Mission::robot().stream(StreamRole::Picture, "left")->topic;
    EXPECT_NEAR(usualRate(*index, "kurt3d", pictures), 13.0 / 40.0, 0.01);
    EXPECT_EQ(usualRate(*index, "nobody", pictures), 0.0);
    EXPECT_NEAR(keyScanRate(*index, "kurt3d"), 18.0 / 40.0, 0.01);
    EXPECT_FALSE(hasSlices(*index, "kurt3d")) << "two slices are evidence, not what a scanner sends";
}

TEST_F(ReviewOpeningTest, WholeTurnsStandInForSlicesThatWereNotKept) {
    const auto log = ReviewLog::open(m_mission).value();
    const ReviewIndexPtr index = indexOf(*log);
    ReviewScene scene(*log, *index);
    const ReviewMomentPtr moment = scene.at(Mission::at(31.0));
    ASSERT_TRUE(moment->robots.at("kurt3d").around);
    EXPECT_LE(moment->robots.at("kurt3d").around->youngest(), 2.5);
}

}  // namespace
}  // namespace leitstand::test
