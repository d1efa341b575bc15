#include <algorithm>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "core/mapping/live/map/cropped_scans.h"
#include "core/mapping/live/scan_cleaning.h"

namespace leitstand::test {
namespace {

const RobotBody Crawler{{{0.2, 0.13}, {-0.2, 0.13}, {-0.2, -0.13}, {0.2, -0.13}}, 0.35};
/// Where it stands; the wall is 5 cm beside it.
const Pose Place = poseFrom({2.0, 1.0, 0.0}, 0, 0, degrees(0));
constexpr double WallY = 1.18;

/// The Crawler's outside, the floor about it, a wall beside it and a ceiling over it, each 2 cm apart [m].
struct Scene {
    std::vector<Eigen::Vector3f> robot, wall, floor, ceiling;

    Scene() {
        for (double z = 0.08; z <= 0.34; z += 0.02) {
            for (double x = 1.8; x <= 2.2; x += 0.02) {
                robot.emplace_back(x, 0.87, z);
                robot.emplace_back(x, 1.13, z);
            }
        }
        for (double x = 1.0; x <= 3.0; x += 0.02) {
            for (double z = 0.02; z <= 1.2; z += 0.02) wall.emplace_back(x, WallY, z);
            for (double y = 0.0; y < WallY; y += 0.04) {
                floor.emplace_back(x, y, 0.0);
                ceiling.emplace_back(x, y, 2.2);
            }
        }
    }
    [[nodiscard]] Scan scan() const {
        Scan scan;
        scan.robot = "kurt3d";
        for (const auto* part : {&robot, &wall, &floor, &ceiling})
            scan.points.insert(scan.points.end(), part->begin(), part->end());
        scan.labels.assign(scan.points.size(), Label::Wall);
        return scan;
    }
};

/// How many of @p points are in @p scan.
std::size_t leftOf(const std::vector<Eigen::Vector3f>& points, const Scan& scan) {
    return static_cast<std::size_t>(std::count_if(points.begin(), points.end(), [&](const auto& point) {
        return std::find(scan.points.begin(), scan.points.end(), point) != scan.points.end();
    }));
}

TEST(OtherRobots, AreLeftOutAndTheWallBesideThemStays) {
    const Scene scene;
    Scan scan = scene.scan();
    leaveOutBodies(scan, std::vector<PlacedBody>{{Crawler, Place}}, Pose::Identity());
    EXPECT_EQ(leftOf(scene.robot, scan), 0U);
    EXPECT_EQ(leftOf(scene.wall, scan), scene.wall.size());
    EXPECT_EQ(leftOf(scene.floor, scan), scene.floor.size());
    EXPECT_EQ(leftOf(scene.ceiling, scan), scene.ceiling.size());
}

TEST(OtherRobots, WhosePlaceIsDoubtedAreLeftOutWithinThatDoubt) {
    const Scene scene;
    for (const double off : {-0.2, 0.15}) {
        Scan scan = scene.scan();
        const Pose wrong = Place * poseFrom({off, -0.5 * off, 0}, 0, 0, degrees(10));
        leaveOutBodies(scan, std::vector<PlacedBody>{{Crawler, wrong}}, Pose::Identity());
        EXPECT_GT(leftOf(scene.robot, scan), scene.robot.size() / 10) << "more than a certain place covers";
        scan = scene.scan();
        leaveOutBodies(scan, std::vector<PlacedBody>{{Crawler, wrong, 0.3}}, Pose::Identity());
        // Its side at the wall cannot be told from that.
        EXPECT_LE(leftOf(scene.robot, scan), scene.robot.size() / 2);
        for (const Eigen::Vector3f& point : scan.points)
            EXPECT_FALSE(point.allFinite() && point.y() < 1.0F && point.z() > 0.06F && point.z() < 0.4F);
        EXPECT_EQ(leftOf(scene.wall, scan), scene.wall.size()) << off;
        EXPECT_EQ(leftOf(scene.floor, scan), scene.floor.size());
    }
}

TEST(OtherRobots, ThatWerePlacedLaterAreTakenOutOfEarlierKeyScansAndComeBackAsTheyWere) {
    const Scene scene;
    CroppedScans cropped;
    LiveKeyScan key;
    key.id = 3;
    key.pose.scanInMap = poseFrom({4.0, -1.0, 0.3}, 0, 0, degrees(35));
    Scan taken = scene.scan();
    for (std::size_t i = 0; i < taken.points.size(); ++i)
        taken.shades.push_back(static_cast<std::uint8_t>(i % 251));
    const ScanPtr whole = std::make_shared<const Scan>(std::move(taken));
    key.scan = whole;
    cropped.fit(key);
    EXPECT_EQ(key.scan, whole);
    cropped.setBodies(3, {{"crawler", Crawler.footprint, Crawler.height, Place, PlacedBody::Certain}});
    cropped.fit(key);
    EXPECT_EQ(leftOf(scene.robot, *key.scan), 0U);
    EXPECT_EQ(leftOf(scene.wall, *key.scan), scene.wall.size());
    EXPECT_EQ(key.scan->labels.size(), key.scan->points.size());
    EXPECT_EQ(leftOf(scene.robot, *whole), scene.robot.size()) << "what was recorded is as it was";
    const ScanPtr before = key.scan;
    cropped.fit(key);
    EXPECT_EQ(key.scan, before) << "not made anew";
    EXPECT_EQ(key.kept->leftOut(), whole->points.size() - before->points.size())
        << "no point is kept twice: each key scan that saw another robot would be";
    MapCrop low;
    low.ceiling = 1.0;
    cropped.setCrop(low);
    cropped.fit(key);
    EXPECT_EQ(leftOf(scene.ceiling, *key.scan), 0U);
    EXPECT_EQ(leftOf(scene.robot, *key.scan), 0U) << "both hold";
    cropped.setCrop({});
    cropped.setBodies(3, {});
    cropped.fit(key);
    EXPECT_EQ(key.scan->points, whole->points);
    EXPECT_EQ(key.scan->labels, whole->labels);
    EXPECT_EQ(key.scan->shades, whole->shades);
    EXPECT_EQ(key.kept->leftOut(), 0U);
}

}  // namespace
}  // namespace leitstand::test
