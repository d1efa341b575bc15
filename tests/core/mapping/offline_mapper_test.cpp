#include "core/mapping/offline_mapper.h"

#include <limits>

#include <gtest/gtest.h>

#include "tests/support/rooms.h"

namespace leitstand {
namespace {

using test::RoomSettings;

/// Scans of a furnished room from a drive of 30 cm steps and slight turns, and where each was truly made.
struct Drive {
    std::vector<ScanPtr> scans;
    std::vector<Pose> truth;  ///< in the first scan's frame
};

/// @p drift: error of the odometry after each step [m].
Drive driveThroughARoom(int count, double drift, Sweep sweep = Sweep::Tilting) {
    Drive drive;
    Pose odometry = Pose::Identity(), previous = Pose::Identity();
    for (int i = 0; i < count; ++i) {
        RoomSettings settings;
        settings.sensorInRoom = poseFrom({-1.5 + 0.3 * i, 0.1 * i, 0.9}, 0, 0, degrees(4.0 * i));
        settings.sweep = sweep;
        settings.rows = sweep == Sweep::Tilting ? 116 : 181;
        settings.columns = sweep == Sweep::Tilting ? 180 : 161;
        settings.seed = static_cast<unsigned>(i + 1);
        Scan scan = test::scanRoom(settings).scan;
        scan.name = "scan" + std::to_string(i);
        const Pose inRoom = settings.sensorInRoom;
        if (i > 0)
            odometry = odometry * previous.inverse() * inRoom *
                       poseFrom({drift, -drift, 0}, 0, 0, degrees(50 * drift));
        previous = inRoom;
        scan.sensorInOdom = odometry;
        drive.scans.push_back(std::make_shared<const Scan>(std::move(scan)));
        drive.truth.push_back(poseFrom({-1.5, 0, 0.9}, 0, 0, 0).inverse() * inRoom);
    }
    return drive;
}

MapPtr mapOf(const Drive& drive, const RegistrationSettings& settings) {
    OfflineMapper mapper(settings);
    for (const ScanPtr& scan : drive.scans) EXPECT_TRUE(mapper.add(scan));
    return mapper.map();
}

class MapperOnBothScanners : public testing::TestWithParam<std::tuple<Sweep, Reference>> {};

TEST_P(MapperOnBothScanners, ADriveIsMappedToItsTruePoses) {
    const Drive drive = driveThroughARoom(6, 0.03, std::get<0>(GetParam()));
    RegistrationSettings settings;
    settings.reference = std::get<1>(GetParam());
    const MapPtr map = mapOf(drive, settings);
    ASSERT_EQ(map->scans.size(), drive.scans.size());
    EXPECT_FALSE(map->scans[0].registered);
    EXPECT_TRUE(map->scans[0].poseInMap.isApprox(Pose::Identity()));
    for (std::size_t i = 1; i < map->scans.size(); ++i) {
        const MapScan& scan = map->scans[i];
        EXPECT_TRUE(scan.registered && scan.icp.converged) << i;
        EXPECT_LT(distanceBetween(scan.poseInMap, drive.truth[i]), 0.02) << i;
        EXPECT_LT(inDegrees(angleBetween(scan.poseInMap, drive.truth[i])), 0.3) << i;
        EXPECT_GT(scan.icp.overlap, 0.6) << i;
        EXPECT_TRUE(scan.icp.certain()) << i << " " << scan.icp.certainty;
        EXPECT_GT(scan.pointsUsed, 500u);
        EXPECT_LT(scan.pointsUsed, scan.scan->points.size());
        EXPECT_EQ(scan.scan->labels.size(), scan.scan->points.size());
    }
}

INSTANTIATE_TEST_SUITE_P(All, MapperOnBothScanners,
                         testing::Combine(testing::Values(Sweep::Tilting, Sweep::Yawing),
                                          testing::Values(Reference::Previous, Reference::Map)));

TEST(OfflineMapper, CountsLabelsAndKeepsThePointsOfAScan) {
    const Drive drive = driveThroughARoom(1, 0.0);
    const MapPtr map = mapOf(drive, {});
    const MapScan& scan = map->scans.front();
    std::size_t sum = 0;
    for (const std::size_t count : scan.labelCounts) sum += count;
    EXPECT_EQ(sum, scan.scan->points.size());
    EXPECT_GT(scan.labelCounts[static_cast<std::size_t>(Label::Floor)], 1'000u);
    EXPECT_GT(scan.labelCounts[static_cast<std::size_t>(Label::Wall)], 1'000u);
    EXPECT_GT(scan.labelCounts[static_cast<std::size_t>(Label::Ceiling)], 1'000u);
    EXPECT_EQ(scan.scan->points.size(), drive.scans.front()->points.size());
}

TEST(OfflineMapper, GuessesComeFromWhereTheSettingsSay) {
    const Drive drive = driveThroughARoom(3, 0.02);
    RegistrationSettings settings;
    const MapPtr odometry = mapOf(drive, settings);
    const Pose step = drive.scans[0]->sensorInOdom.inverse() * drive.scans[1]->sensorInOdom;
    EXPECT_TRUE(odometry->scans[1].guessInMap.isApprox(odometry->scans[0].poseInMap * step, 1e-9));

    settings.guess = GuessSource::Identity;
    const MapPtr identity = mapOf(drive, settings);
    EXPECT_TRUE(identity->scans[2].guessInMap.isApprox(identity->scans[1].poseInMap, 1e-9));

    settings.guess = GuessSource::Poses;
    settings.guessPoses = drive.truth;
    const MapPtr poses = mapOf(drive, settings);
    EXPECT_TRUE(poses->scans[2].guessInMap.isApprox(drive.truth[2], 1e-9));
}

TEST(OfflineMapper, LearnsHowFarTheRobotGoesByItsOdometry) {
    constexpr double TooLong = 1.08;
    Drive drive;
    Pose odometry = Pose::Identity(), previous = Pose::Identity();
    for (int i = 0; i < 45; ++i) {  // to and fro
        const int place = i % 20 < 10 ? i % 20 : 20 - i % 20;
        RoomSettings settings;
        settings.sensorInRoom = poseFrom({-1.5 + 0.3 * place, 0.2, 0.9}, 0, 0, 0);
        settings.sweep = Sweep::Yawing;
        settings.rows = 121;
        settings.columns = 81;
        settings.seed = static_cast<unsigned>(i + 1);
        Scan scan = test::scanRoom(settings).scan;
        if (i > 0) {
            Pose step = previous.inverse() * settings.sensorInRoom;
            step.translation() *= TooLong;
            odometry = odometry * step;
        }
        previous = settings.sensorInRoom;
        scan.sensorInOdom = odometry;
        drive.scans.push_back(std::make_shared<const Scan>(std::move(scan)));
    }
    const MapPtr map = mapOf(drive, {});
    const auto guessed = [&](std::size_t i) {
        return (map->scans[i - 1].poseInMap.inverse() * map->scans[i].guessInMap).translation().norm();
    };
    EXPECT_NEAR(guessed(1), 0.3 * TooLong, 1e-3) << "nothing is known yet";
    EXPECT_NEAR(guessed(44), 0.3, 0.5 * 0.3 * (TooLong - 1.0)) << "after 13 m";
}

TEST(OfflineMapper, ScansWithoutOdometryStartAtThePreviousPose) {
    Drive drive = driveThroughARoom(2, 0.0);
    Scan blind = *drive.scans[1];
    blind.hasOdometry = false;
    blind.sensorInOdom = poseFrom({100, 0, 0}, 0, 0, 0);
    drive.scans[1] = std::make_shared<const Scan>(blind);
    const MapPtr map = mapOf(drive, {});
    EXPECT_TRUE(map->scans[1].guessInMap.isApprox(Pose::Identity()));
    EXPECT_LT(distanceBetween(map->scans[1].poseInMap, drive.truth[1]), 0.02);
}

TEST(OfflineMapper, AScanThatCannotBeAlignedEntersAtItsGuessAndTheNextOneGoesOn) {
    Drive drive = driveThroughARoom(3, 0.0);
    Scan dark = *drive.scans[1];
    for (Eigen::Vector3f& point : dark.points) point.setConstant(std::numeric_limits<float>::quiet_NaN());
    drive.scans[1] = std::make_shared<const Scan>(dark);
    for (const Reference reference : {Reference::Previous, Reference::Map}) {
        RegistrationSettings settings;
        settings.reference = reference;
        const MapPtr map = mapOf(drive, settings);
        ASSERT_EQ(map->scans.size(), 3u);
        EXPECT_FALSE(map->scans[1].icp.converged);
        EXPECT_EQ(map->scans[1].pointsUsed, 0u);
        EXPECT_TRUE(map->scans[1].poseInMap.isApprox(map->scans[1].guessInMap));
        EXPECT_TRUE(map->scans[2].icp.converged);
        EXPECT_LT(distanceBetween(map->scans[2].poseInMap, drive.truth[2]), 0.02);
    }
}

TEST(OfflineMapper, CancellingLeavesWhatWasFinished) {
    const Drive drive = driveThroughARoom(3, 0.0);
    OfflineMapper mapper({});
    std::stop_source stop;
    EXPECT_TRUE(mapper.add(drive.scans[0]));
    EXPECT_TRUE(mapper.add(drive.scans[1]));
    stop.request_stop();
    EXPECT_FALSE(mapper.add(drive.scans[2], {{}, stop.get_token()}));
    EXPECT_EQ(mapper.map()->scans.size(), 2u);
    EXPECT_TRUE(mapper.add(drive.scans[2])) << "and can go on later";
    EXPECT_EQ(mapper.map()->scans.size(), 3u);
}

TEST(OfflineMapper, ProgressRisesToOne) {
    const Drive drive = driveThroughARoom(2, 0.0);
    OfflineMapper mapper({});
    ASSERT_TRUE(mapper.add(drive.scans[0]));
    double last = 0.0;
    ASSERT_TRUE(mapper.add(drive.scans[1], {[&](double fraction) {
                                                EXPECT_GE(fraction, last);
                                                last = fraction;
                                            },
                                            {}}));
    EXPECT_EQ(last, 1.0);
}

TEST(OfflineMapper, SnapshotsDoNotChangeLater) {
    const Drive drive = driveThroughARoom(2, 0.0);
    OfflineMapper mapper({});
    ASSERT_TRUE(mapper.add(drive.scans[0]));
    const MapPtr before = mapper.map();
    ASSERT_TRUE(mapper.add(drive.scans[1]));
    EXPECT_EQ(before->scans.size(), 1u);
}

TEST(OfflineMapper, TheResultDoesNotDependOnThreads) {
    const Drive drive = driveThroughARoom(3, 0.03);
    RegistrationSettings settings;
    settings.threads = 1;
    const MapPtr one = mapOf(drive, settings);
    settings.threads = 2;
    const MapPtr two = mapOf(drive, settings);
    EXPECT_TRUE((one->scans[2].poseInMap.matrix().array() == two->scans[2].poseInMap.matrix().array()).all());
}

}  // namespace
}  // namespace leitstand
