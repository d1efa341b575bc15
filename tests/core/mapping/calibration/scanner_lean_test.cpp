#include "core/mapping/calibration/scanner_lean.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace leitstand::test {
namespace {

/// A robot that drives about, whose scanner leans by more than is said of it; the map's own tilt wanders.
struct LeaningDrive {
    Eigen::Vector2d lean{degrees(0.4), degrees(-0.3)};             ///< roll, pitch [rad]
    Pose sensorInBase = poseFrom({0, 0, 0.5}, 0, 0, degrees(90));  ///< as it is said
    ScannerLean found;
    Eigen::Vector2d tilt{degrees(0.5), degrees(0.2)};  ///< of the map
    double heading = 0.0;
    std::mt19937 random{1};

    /// @p level: the mapper keeps the map level with what is known of the lean.
    void drive(int scans, double turn, bool level = false) {
        std::normal_distribution<double> wander(0.0, degrees(0.02)), unit(0.0, degrees(0.1));
        const Pose truly =
            poseFrom({0, 0, 0.5}, lean.x(), lean.y(), 0.0) * poseFrom({0, 0, 0}, 0, 0, degrees(90));
        for (int i = 0; i < scans; ++i) {
            heading += turn;
            tilt += Eigen::Vector2d(wander(random), wander(random));
            const Pose map = poseFrom({0, 0, 0}, tilt.x(), tilt.y(), 0.0);
            const Pose baseInMap = map * poseFrom({0, 0, 0}, 0, 0, heading);
            const Pose scanInMap = baseInMap * truly;
            // The unit is fixed to the base, its word is turned into the scan by the mount as it is said.
            const Eigen::Vector3d up = sensorInBase.linear().transpose() *
                                       Eigen::Vector3d(unit(random), unit(random), 1.0).normalized();
            found.add(scanInMap, sensorInBase, up, 0.3);
            if (!level) continue;
            const Eigen::Vector3d known = scanInMap.linear() * found.corrected(up, sensorInBase);
            Pose levelled = scanInMap;
            levelled.linear() = Eigen::Quaterniond::FromTwoVectors(
                                    known, Eigen::Vector3d(0.9 * known.x(), 0.9 * known.y(), known.z()))
                                    .toRotationMatrix() *
                                scanInMap.linear();
            found.entered(scanInMap, levelled, up);
            // It is one of a dozen scans that the next one is matched with.
            tilt += 0.1 / 6.5 * Eigen::Vector2d(known.y(), -known.x());
        }
    }
};

TEST(ScannerLean, IsToldFromTheMapsOwnTiltOnceTheRobotTurned) {
    LeaningDrive drive;
    drive.drive(60, degrees(0.2));
    EXPECT_GT(drive.found.deviation().norm(), degrees(0.5)) << "the robot went nearly straight ahead";
    for (int i = 0; i < 8; ++i) {
        drive.drive(5, degrees(18));
        drive.drive(10, 0.0);
    }
    EXPECT_NEAR(drive.found.lean().x(), drive.lean.x(), degrees(0.08));
    EXPECT_NEAR(drive.found.lean().y(), drive.lean.y(), degrees(0.08));
    EXPECT_LT(drive.found.deviation().norm(), degrees(0.15));
}

TEST(ScannerLean, IsTheSameWhileTheMapIsKeptLevel) {
    LeaningDrive drive;
    for (int i = 0; i < 10; ++i) {
        drive.drive(5, degrees(18), true);
        drive.drive(10, 0.0, true);
    }
    EXPECT_NEAR(drive.found.lean().x(), drive.lean.x(), degrees(0.08));
    EXPECT_NEAR(drive.found.lean().y(), drive.lean.y(), degrees(0.08));
    EXPECT_LT(drive.tilt.norm(), degrees(0.12)) << "a lean that is known does not tilt the map";
}

TEST(ScannerLean, IsNoneOfOneThatSitsAsItIsSaid) {
    LeaningDrive drive;
    drive.lean.setZero();
    for (int i = 0; i < 8; ++i) drive.drive(15, degrees(12));
    EXPECT_LT(drive.found.lean().norm(), degrees(0.08));
    const Eigen::Vector3d up(0.1, 0.0, 1.0);
    EXPECT_TRUE(ScannerLean().corrected(up.normalized(), Pose::Identity()).isApprox(up.normalized(), 1e-12));
}

TEST(ScannerLean, IsNotMadeUpWhereTheMapIsTiltedAndTheRobotStands) {
    LeaningDrive drive;
    drive.lean.setZero();
    drive.tilt = {degrees(1), 0.0};
    drive.drive(60, 0.0);
    drive.drive(5, degrees(18));
    drive.drive(60, 0.0);
    EXPECT_LT(drive.found.lean().norm(), degrees(0.2));
}

TEST(ScannerLean, IsNotMadeUpWhereTheMapMovesUnderTheRobot) {
    for (const int scans : {20, 50, 80}) {
        LeaningDrive drive;
        drive.lean.setZero();
        drive.drive(scans, degrees(6));
        drive.tilt += Eigen::Vector2d(degrees(1), degrees(-0.5));
        drive.found.mapMoved();
        drive.drive(scans, degrees(6));
        EXPECT_LT(drive.found.lean().norm(), degrees(0.15)) << scans;
    }
}

TEST(ScannerLean, OfAScannerThatWasKnockedIsLearntAnew) {
    LeaningDrive drive;
    drive.drive(150, degrees(6));
    drive.lean = {degrees(-1.2), degrees(1.2)};
    drive.drive(150, degrees(6));
    EXPECT_NEAR(drive.found.lean().x(), drive.lean.x(), degrees(0.1));
    EXPECT_NEAR(drive.found.lean().y(), drive.lean.y(), degrees(0.1));
}

}  // namespace
}  // namespace leitstand::test
