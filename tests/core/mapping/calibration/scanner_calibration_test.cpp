#include "core/mapping/calibration/scanner_calibration.h"

#include <gtest/gtest.h>

namespace leitstand::test {
namespace {

ScannerCalibration calibration(double range, double roll, double deviation = degrees(0.03)) {
    ScannerCalibration reported;
    reported.range = Estimated{range, 0.0005};
    reported.lean = {roll, 0.0};
    reported.leanDeviation = {deviation, deviation};
    return reported;
}

TEST(ScannerCalibration, AdvisesWhatIsCertainAndMatters) {
    EXPECT_EQ(ScannerCalibration().advised(), std::nullopt);
    EXPECT_EQ(calibration(0.005, degrees(0.1)).advised(), std::nullopt) << "too little to be noticed";
    EXPECT_EQ(calibration(0.02, degrees(0.5)).advised(), (ScannerCorrection{-0.02, 0.0, 0.0}))
        << "ranges first: a lean may come of them";
    EXPECT_EQ(calibration(-0.02, 0.0).advised(), (ScannerCorrection{0.02, 0.0, 0.0}));
    EXPECT_EQ(calibration(0.002, degrees(0.5)).advised(), (ScannerCorrection{0.0, degrees(0.5), 0.0}));
    EXPECT_EQ(calibration(0.002, degrees(0.5), degrees(0.3)).advised(), std::nullopt) << "not sure yet";
    EXPECT_EQ(calibration(0.008, 0.0).advised(), std::nullopt);
    EXPECT_TRUE(calibration(0.008, 0.0).advised(ScannerCorrection{-0.01}).has_value())
        << "what was told does not come and go";
    EXPECT_EQ(calibration(0.005, 0.0).advised(ScannerCorrection{-0.01}), std::nullopt);
    ScannerCalibration scattered = calibration(0.02, degrees(0.5));
    scattered.range->deviation = 0.01;
    EXPECT_EQ(scattered.advised(), std::nullopt);
    ScannerCalibration untold = calibration(0.0, degrees(0.5));
    untold.range.reset();
    EXPECT_EQ(untold.advised(), std::nullopt) << "a lean is told once ranges are known to be right";
}

/// What is told of a scanner whose ranges and lean are right.
ScannerCalibration mounted(const Eigen::Vector4d& off, double share) {
    ScannerCalibration reported = calibration(0.0, 0.0);
    reported.mount = MountError{off, share * off.cwiseAbs()};
    return reported;
}

TEST(ScannerCalibration, AdvisesTheClockAndThenWhereTheScannerSits) {
    const Eigen::Vector4d off(0.02, -0.005, degrees(0.8), 0.06);
    ScannerCorrection clock, mount;
    clock.clock = -0.06;
    mount.x = 0.02;
    mount.yaw = degrees(0.8);
    EXPECT_EQ(mounted(off, 0.1).advised(), clock) << "how it sits shows once it is on time";
    EXPECT_EQ(mounted({0.02, -0.005, degrees(0.8), 0.01}, 0.1).advised(), mount)
        << "what is too little to be noticed stays";
    EXPECT_EQ(mounted(off, 0.5).advised(), std::nullopt) << "not sure yet";
    ScannerCalibration scattered = mounted(off, 0.1);
    scattered.mount->deviation[3] = 0.007;
    EXPECT_EQ(scattered.advised(), std::nullopt) << "what is left would be told again; how it sits waits";
    EXPECT_EQ(scattered.advised(clock), clock) << "what stands does not come and go";
    scattered.mount->value[3] = 0.3;
    EXPECT_EQ(scattered.advised()->clock, -0.3) << "a tenth of it is sure enough";
    ScannerCalibration leaning = mounted(off, 0.1);
    leaning.lean.x() = degrees(1);
    EXPECT_EQ(faultOf(leaning.advised().value()), ScannerFault::Lean);
    EXPECT_EQ(leaning.advised({}, {ScannerFault::Lean}), clock) << "what is left as it is hides nothing";
    EXPECT_EQ(faultOf(leaning.advised({}, {ScannerFault::Lean, ScannerFault::Clock}).value()),
              ScannerFault::Mount);
    EXPECT_EQ(mounted({0.008, 0.0, 0.0, 0.016}, 0.1).advised(ScannerCorrection{-0.01}), std::nullopt)
        << "that ranges were asked about makes nothing else surer";
    EXPECT_EQ(mounted({0.008, 0.0, 0.0, 0.016}, 0.1).advised(clock)->clock, -0.016) << "it still stands";
    leaning = mounted(off, 0.1);
    leaning.range.reset();
    EXPECT_EQ(leaning.advised(), clock) << "ranges say nothing about it";
    EXPECT_EQ(faultOf(clock), ScannerFault::Clock);
    EXPECT_EQ(faultOf(mount), ScannerFault::Mount);
    EXPECT_TRUE(asksAlike(clock, clock));
    EXPECT_FALSE(asksAlike(clock, mount));
    ScannerCorrection other = mount;
    other.yaw += degrees(0.2);
    EXPECT_FALSE(asksAlike(mount, other));
}

}  // namespace
}  // namespace leitstand::test
