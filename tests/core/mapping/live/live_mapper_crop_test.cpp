#include <array>

#include <gtest/gtest.h>

#include "core/mapping/live/scan_doubts.h"
#include "tests/core/mapping/live/mapped_room.h"

namespace leitstand::test {
namespace {

TEST(LiveMapperCrop, CroppedPointsAreNeitherMatchedNorMapped) {
    MappedRoom room;
    MapCrop crop;
    crop.ceiling = 0.5;
    crop.polygon = {{-2, -2}, {3, -2}, {3, 2}, {-2, 2}};
    room.mapper.setCrop(crop);
    const MapUpdate update = room.add(poseFrom({-1.4, 0, 0.9}, 0, 0, 0));
    for (const Eigen::Vector3f& point : update.keyScan->scan->points) {
        ASSERT_TRUE(point.z() <= 0.5F && std::abs(point.y()) <= 2.0F);
    }
    EXPECT_EQ(update.keyScan->scan->labels.size(), update.keyScan->scan->points.size());
}

MapCrop narrowArea() {
    MapCrop crop;
    crop.ceiling = 0.5;
    crop.polygon = {{-5, -1}, {9, -1}, {9, 9}, {-5, 9}};
    return crop;
}

/// Of @p map's scans: points, and those of them outside @p crop; then likewise of what is matched.
std::array<std::size_t, 4> outside(const LiveMap& map, const MapCrop& crop) {
    std::array<std::size_t, 4> counted{};
    for (const LiveKeyScan& scan : map.scans) {
        const PointCloud matched = scan.reduced->unpacked();
        for (std::size_t which : {0U, 2U}) {
            for (const Eigen::Vector3f& point : which == 0 ? scan.scan->points : matched.points) {
                ++counted.at(which);
                counted.at(which + 1) += crop.contains(scan.pose.scanInMap * point.cast<double>()) ? 0U : 1U;
            }
        }
        EXPECT_EQ(scan.scan->labels.size(), scan.scan->points.size());
        EXPECT_EQ(matched.normals.size(), matched.points.size());
    }
    return counted;
}

TEST(LiveMapperCrop, AnAreaThatIsDrawnLaterLeavesOutWhatIsInTheMapAndAWiderOneBringsItBack) {
    MappedRoom room;
    room.drive(4);
    const MapCrop area = narrowArea();
    const LiveMapPtr before = room.mapper.map();
    const auto whole = outside(*before, area);
    ASSERT_GT(whole[1], whole[0] / 5);
    ASSERT_GT(whole[3], whole[2] / 5);
    room.mapper.setCrop(area);
    const LiveMapPtr cropped = room.mapper.map();
    const auto inside = outside(*cropped, area);
    EXPECT_EQ(inside[0], whole[0] - whole[1]);
    EXPECT_EQ(inside[1], 0U);
    EXPECT_EQ(inside[2], whole[2] - whole[3]);
    EXPECT_EQ(inside[3], 0U);
    room.mapper.setCrop(area);
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_EQ(room.mapper.map()->scans[i].scan, cropped->scans[i].scan) << "nothing changed";
    const MapUpdate next = room.add(room.last * poseFrom({0.3, 0, 0}, 0, 0, 0));
    EXPECT_EQ(next.localisation.doubts, 0) << inWords(next.localisation.doubts);
    room.mapper.setCrop({});
    const LiveMapPtr after = room.mapper.map();
    for (std::size_t i = 0; i < 4; ++i) {
        const LiveKeyScan &now = after->scans[i], &then = before->scans[i];
        EXPECT_EQ(now.scan->points, then.scan->points) << i;
        EXPECT_EQ(now.scan->labels, then.scan->labels) << i;
        EXPECT_EQ(now.scan->shades, then.scan->shades) << i;
        EXPECT_EQ(now.reduced, then.reduced) << i;
    }
}

TEST(LiveMapperCrop, AScanThatIsMovedIsCroppedFromWhereItStandsAlsoAfterARestart) {
    MappedRoom room;
    room.drive(3);
    const MapCrop area = narrowArea();
    room.mapper.setCrop(area);
    std::vector<ScanPose> poses = room.poses();
    poses[1].scanInMap = poseFrom({0.5, 1.0, 0}, 0, 0, 0) * poses[1].scanInMap;
    room.mapper.follow(poses);
    EXPECT_EQ(outside(*room.mapper.map(), area)[1], 0U);
    LiveSettings settings;
    settings.crop = area;
    const auto again = outside(*room.log.readAgain(settings).map(), area);
    EXPECT_GT(again[0], 1000U);
    EXPECT_EQ(again[1], 0U);
    EXPECT_EQ(again[3], 0U);
}

TEST(LiveMapperCrop, AScanIsCroppedFromWhereItFitsNotFromWhereOdometryPutIt) {
    MappedRoom room;
    room.drive(3);
    const MapCrop area = narrowArea();
    room.mapper.setCrop(area);
    const Pose place = poseFrom({0.05, 0.15, 0.9}, 0, 0, degrees(9));
    const MapUpdate update = room.add(place, poseFrom({0, 0.15, 0}, 0, 0, degrees(3)));
    ASSERT_TRUE(update.keyScan);
    EXPECT_EQ(update.localisation.doubts, 0) << inWords(update.localisation.doubts);
    const Localisation& here = update.localisation;
    ASSERT_GT(distanceBetween(here.baseInMap, here.guessInMap), 0.1) << "odometry was wrong";
    const auto counted = outside(*room.mapper.map(), area);
    EXPECT_EQ(counted[1], 0U);
    EXPECT_EQ(counted[3], 0U);
}

TEST(LiveMapperCrop, AnAreaWithoutAnyOfTheMapLeavesRobotsWhereTheyAre) {
    MappedRoom room;
    room.drive(3);
    MapCrop elsewhere;
    elsewhere.polygon = {{50, 50}, {51, 50}, {51, 51}};
    room.mapper.setCrop(elsewhere);
    EXPECT_EQ(outside(*room.mapper.map(), elsewhere)[0], 0U);
    const MapUpdate next = room.add(room.last * poseFrom({0.3, 0, 0}, 0, 0, 0));
    EXPECT_NE(next.localisation.doubts, 0);
    EXPECT_LT(distanceBetween(next.localisation.baseInMap, next.localisation.guessInMap), 1e-6);
    room.mapper.setCrop({});
    EXPECT_EQ(room.add(room.last).localisation.doubts, 0) << "drawn by mistake, taken back";
}

}  // namespace
}  // namespace leitstand::test
