#include "core/mapping/calibration/scanner_calibration.h"

#include <gtest/gtest.h>

namespace leitstand::test {
namespace {

ScannerCalibration calibration(double range, double roll, double deviation = degrees(0.03)) {
    ScannerCalibration told;
    told.range = Estimated{range, 0.0005};
    told.lean = {roll, 0.0};
    told.leanDeviation = {deviation, deviation};
    return told;
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
    EXPECT_TRUE(calibration(0.008, 0.0).advised(true).has_value()) << "what was told does not come and go";
    EXPECT_EQ(calibration(0.005, 0.0).advised(true), std::nullopt);
    ScannerCalibration scattered = calibration(0.02, degrees(0.5));
    scattered.range->deviation = 0.01;
    EXPECT_EQ(scattered.advised(), std::nullopt);
    ScannerCalibration untold = calibration(0.0, degrees(0.5));
    untold.range.reset();
    EXPECT_EQ(untold.advised(), std::nullopt) << "a lean is told once ranges are known to be right";
}

}  // namespace
}  // namespace leitstand::test
