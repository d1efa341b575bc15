#include "app/services/review/review_pointing.h"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/services/review/review_pen.h"
#include "core/event/map_samples.h"
#include "core/event/station_topics.h"
#include "core/mission/state/find_state.h"
#include "tests/app/review/written_mission.h"
#include "tests/support/places.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

using Mission = WrittenMission;
using testing::HasSubstr;

/// A robot that drives 0.1 m/s ahead for 20 s towards a wall that is always 2 m before its scanner; its left
/// camera looks ahead.
class ReviewPointingTest : public testing::Test {
protected:
    enum class Scans { Slices, WholeTurns };
    void write(Scans scans) {
        Mission mission(m_mission);
        mission.sayCamera(0.0);
        for (int i = 0; i <= 200; ++i) {
            const double t = 0.1 * i;
            if (scans == Scans::Slices)
                mission.sayPlace(t, 0.1 * t);
            else
                mission.sayOdometry(t, 0.1 * t);
            if (i % 5 == 0) mission.sayPicture(t, 100);
            if (i % 50 == 0) sayKeyScan(mission, t, static_cast<std::uint64_t>(i / 50 + 1));
        }
        mission.close();
        m_log = ReviewLog::open(m_mission).value();
        m_index = indexOf(*m_log);
        m_scene = std::make_unique<ReviewScene>(*m_log, *m_index);
    }
    /// Of a wall at x = 4 m, as seen from where the robot was then.
    static void sayKeyScan(Mission& mission, double seconds, std::uint64_t id) {
        const double x = 0.1 * seconds;
        auto points = std::make_shared<Scan>();
        points->robot = "kurt3d";
        points->sensorInOdom = poseFrom({x, 0, 0.4}, 0, 0, 0);
        points->hasOdometry = true;
        for (int row = -20; row <= 20; ++row) {
            for (int column = -20; column <= 20; ++column) {
                points->points.emplace_back(4.0 - x, 0.05 * column, 0.05 * row);
                points->labels.push_back(Label::Wall);
            }
        }
        KeyScanSample scan;
        scan.stamp = Mission::at(seconds);
        scan.id = id;
        scan.scan = std::move(points);
        scan.sensorInBase = poseFrom({0, 0, 0.4}, 0, 0, 0);
        scan.scanInMap = poseFrom({x, 0, 0.4}, 0, 0, 0);
        scan.matched = id - 1;
        mission.publish(seconds, std::string(station_topic::KeyScans), scan);
    }
    Result<FrozenEvidence> point(double seconds, const Eigen::Vector2d& share,
                                 const std::string& sensor = "left") {
        const ReviewMomentPtr moment = m_scene->at(Mission::at(seconds));
        return evidenceIn(m_mission, *m_index, *moment, "kurt3d", *moment->mission, {sensor, share});
    }

    const TemporaryFolder m_folder;
    const std::filesystem::path m_mission = m_folder / "mission";
    std::unique_ptr<ReviewLog> m_log;
    ReviewIndexPtr m_index;
    std::unique_ptr<ReviewScene> m_scene;
};

TEST_F(ReviewPointingTest, WhatIsPointedToIsWhereTheScannerSawIt) {
    write(Scans::Slices);
    const auto seen = point(12.04, {0.5, 0.5});
    ASSERT_TRUE(seen) << seen.error().text;
    EXPECT_NEAR(seen->positionInMap.x(), 1.2 + 2.0, 0.25) << "at 12 s the robot is at 1.2 m";
    EXPECT_NEAR(seen->positionInMap.y(), 0.0, 0.15) << "the camera is 8 cm to the left";
    EXPECT_GT(seen->deviation, 0.0);
    EXPECT_LT(seen->deviation, 0.3);
    EXPECT_EQ(seen->scan, 3U) << "it hangs on the newest key scan";
    EXPECT_EQ(seen->found, Mission::at(12.04));
    EXPECT_TRUE(std::any_of(seen->evidence.begin(), seen->evidence.end(),
                            [](const VictimEvidence& one) { return one.kind == "picture"; }));
    const auto beside = point(12.04, {0.2, 0.5});
    ASSERT_TRUE(beside);
    EXPECT_GT(beside->positionInMap.y(), seen->positionInMap.y() + 0.3) << "left in the picture is left";

    ReviewPen pen(m_mission, {Mission::robot()}, "reviewer", "test");
    ASSERT_TRUE(pen.file(FindSample::Kind::Hazard, *seen).ok());
    const FindSample filed = pen.state()->finds->at({FindSample::Kind::Hazard, 1}).victim;
    EXPECT_TRUE(filed.positionInMap.isApprox(seen->positionInMap, 1e-6));
}

TEST_F(ReviewPointingTest, WithoutSlicesWholeTurnsTellHowFarItIs) {
    write(Scans::WholeTurns);
    for (const double seconds : {7.0, 18.0}) {
        const auto seen = point(seconds, {0.5, 0.5});
        ASSERT_TRUE(seen) << seen.error().text;
        EXPECT_NEAR(seen->positionInMap.x(), 4.0, 0.2) << seconds;
    }
}

TEST_F(ReviewPointingTest, WhereNothingWasScannedNothingIsFiledAndThatIsTold) {
    write(Scans::Slices);
    const auto nobody = point(12.04, {0.5, 0.5}, "right");
    ASSERT_FALSE(nobody);
    EXPECT_THAT(nobody.error().text, HasSubstr("on the map"));
    const ReviewMomentPtr moment = m_scene->at(Mission::at(12.0));
    const auto other = evidenceIn(m_mission, *m_index, *moment, "crawler", *moment->mission, {"left"});
    ASSERT_FALSE(other);
    EXPECT_THAT(other.error().text, HasSubstr("not in the map then"));
    EXPECT_FALSE(evidenceIn(m_folder / "none", *m_index, *moment, "kurt3d", *moment->mission, {"left"}));
}

TEST(ReviewPointing, ABodyInAPictureOfTheShippedMissionIsWhereItsVictimWasFiled) {
    const std::filesystem::path mission = sourceFolder() + "/resources/samples/yellow-7";
    const auto log = ReviewLog::open(mission).value();
    const ReviewIndexPtr index = indexOf(*log);
    ReviewScene scene(*log, *index);
    const ReviewMomentPtr moment = scene.at(log->last() - std::chrono::seconds(5));
    // It lies at the left of the left camera's picture, its feet towards the robot.
    const auto seen =
        evidenceIn(mission, *index, *moment, "kurt3d", *moment->mission, {"left", {0.14, 0.69}});
    ASSERT_TRUE(seen) << seen.error().text;
    const Eigen::Vector3d filed =
        index->finished->finds->at({FindSample::Kind::Victim, 1}).victim.positionInMap;
    EXPECT_LT((seen->positionInMap - filed).head<2>().norm(), 0.6)
        << seen->positionInMap.transpose() << " and " << filed.transpose();
}

}  // namespace
}  // namespace leitstand::test
