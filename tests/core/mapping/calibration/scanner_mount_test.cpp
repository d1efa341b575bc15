#include "core/mapping/calibration/scanner_mount.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace leitstand::test {
namespace {

/// A robot that drives about, straight on and in curves of its own speed, with a scanner that sits and looks
/// otherwise than it is said to.
struct MountedDrive {
    Pose reported = poseFrom({0.2, 0.1, 0.5}, 0, 0, degrees(30));
    Eigen::Vector3d off = Eigen::Vector3d::Zero();  ///< x, y [m], yaw [rad]
    double late = 0.0;                              ///< [s]
    double slipsInTurns = 0.0;                      ///< share of the turn that odometry tells too much
    double wayTooLong = 0.0;                        ///< share
    ScannerMount found;
    std::mt19937 random{1};

    /// The base at @p time [s]: now straight, now in a curve, at 0.3 m/s.
    static Pose baseAt(double time) {
        const double x = 0.3 * time, y = 1.5 * std::sin(0.35 * time);
        const double heading = std::atan2(1.5 * 0.35 * std::cos(0.35 * time), 0.3);
        return poseFrom({x, y, 0}, 0, 0, heading);
    }
    void drive(double seconds, double step = 0.5) {
        std::normal_distribution<double> place(0.0, 0.002), heading(0.0, degrees(0.05));
        const Pose truly =
            poseFrom({reported.translation().x() + off.x(), reported.translation().y() + off.y(), 0.5}, 0, 0,
                     degrees(30) + off.z());
        Pose odometry = Pose::Identity();
        for (double time = 0.0; time < seconds; time += step) {
            // Slips and scale act on the way of odometry, from the time at which it is asked for.
            const double asked = time + late;
            Pose moved = baseAt(asked - step).inverse() * baseAt(asked);
            const double turn = std::atan2(moved.linear()(1, 0), moved.linear()(0, 0));
            moved = poseFrom((1.0 + wayTooLong) * moved.translation(), 0, 0, (1.0 + slipsInTurns) * turn);
            odometry = odometry * moved;
            const Pose begun = baseAt(asked - 0.1).inverse() * baseAt(asked);
            ScanMotion scan;
            scan.sensorInMap =
                baseAt(time) * truly * poseFrom({place(random), place(random), 0}, 0, 0, heading(random));
            scan.sensorInOdom = odometry * reported;
            scan.sensorInBase = reported;
            scan.velocity = begun.translation().head<2>() / 0.1;
            scan.yawRate = std::atan2(begun.linear()(1, 0), begun.linear()(0, 0)) / 0.1;
            found.add(scan);
        }
    }
    [[nodiscard]] MountError estimate() const { return found.estimate().value(); }
};

void expectNear(const MountError& reported, const Eigen::Vector4d& truly) {
    const Eigen::Vector4d bounds(0.005, 0.005, degrees(0.15), 0.006);
    for (int i = 0; i < 4; ++i) {
        EXPECT_NEAR(reported.value[i], truly[i], bounds[i]) << i;
        EXPECT_LT(std::abs(reported.value[i] - truly[i]), 3.0 * reported.deviation[i]) << i;
        EXPECT_LT(reported.deviation[i], bounds[i]) << i;
    }
}

TEST(ScannerMount, IsNothingAboutOneThatSitsAsItIsSaid) {
    MountedDrive drive;
    EXPECT_EQ(drive.found.estimate(), std::nullopt);
    drive.drive(180.0);
    expectNear(drive.estimate(), Eigen::Vector4d::Zero());
}

TEST(ScannerMount, TellsPlaceHeadingAndClockFromOneDrive) {
    MountedDrive drive;
    drive.off = {0.02, -0.015, degrees(0.8)};
    drive.late = 0.06;
    drive.drive(180.0);
    expectNear(drive.estimate(), {0.02, -0.015, degrees(0.8), 0.06});
}

TEST(ScannerMount, IsNotMisledByOdometryThatSlipsAndTellsWaysTooLong) {
    MountedDrive drive;
    drive.off = {0.0, 0.0, degrees(-0.6)};
    drive.slipsInTurns = 0.05;
    drive.wayTooLong = 0.04;
    drive.drive(180.0);
    expectNear(drive.estimate(), {0.0, 0.0, degrees(-0.6), 0.0});
}

TEST(ScannerMount, OnAStraightWayOnlyTheHeadingIsTold) {
    MountedDrive drive;
    drive.off = {0.03, 0.03, degrees(1.0)};
    const Pose truly = poseFrom({0.23, 0.13, 0.5}, 0, 0, degrees(31));
    for (int i = 0; i < 500; ++i) {
        const Pose base = poseFrom({0.1 * i, 0, 0}, 0, 0, 0);
        drive.found.add({base * truly, base * drive.reported, drive.reported, {0.2, 0.0}, 0.0});
    }
    const MountError reported = drive.estimate();
    EXPECT_NEAR(reported.value[2], degrees(1.0), degrees(0.05));
    EXPECT_GT(reported.deviation[0], 0.05) << "nobody knows where it sits";
    EXPECT_GT(reported.deviation[1], 0.05);
    EXPECT_GT(reported.deviation[3], 0.05) << "nor how late it is";
}

TEST(ScannerMount, AWayThatIsNotKnownSaysNothing) {
    MountedDrive drive;
    drive.drive(60.0);
    const std::size_t before = drive.found.pairs();
    drive.found.breakOff();
    const Pose elsewhere = poseFrom({50, 50, 0}, 0, 0, 2.0);
    drive.found.add({elsewhere, drive.reported, drive.reported, {0, 0}, 0.0});
    EXPECT_EQ(drive.found.pairs(), before);
}

}  // namespace
}  // namespace leitstand::test
