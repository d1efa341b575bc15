#include "core/mapping/motion/turn_gyro.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace leitstand {
namespace {

Time at(int ms) {
    return Time(std::chrono::seconds(100) + std::chrono::milliseconds(ms));
}

/// Rates that rise by 1 rad/s a second.
TurnGyro rising(int from, int to) {
    TurnGyro gyro;
    for (int ms = from; ms <= to; ms += 20) gyro.add(at(ms), 1e-3 * ms);
    return gyro;
}

TEST(TurnGyro, AddsUpTheRates) {
    const TurnGyro gyro = rising(0, 2000);
    EXPECT_NEAR(gyro.turned(at(0), at(2000)).value(), 2.0, 1e-9);
    EXPECT_NEAR(gyro.turned(at(1000), at(1010)).value(), 0.01 * 1.005, 1e-9) << "between two of them";
    EXPECT_NEAR(gyro.turned(at(2000), at(2050)).value(), 0.1, 1e-9) << "the newest counts on";
    EXPECT_FALSE(gyro.turned(at(0), at(2200))) << "but not for long";
    EXPECT_FALSE(gyro.turned(at(-10), at(100)));
    EXPECT_FALSE(TurnGyro().turned(at(0), at(1)));
}

TEST(TurnGyro, SaysNothingAcrossAGap) {
    TurnGyro gyro = rising(0, 1000);
    gyro.add(at(1500), 1.0);
    gyro.add(at(1520), 1.0);
    EXPECT_FALSE(gyro.turned(at(900), at(1510)));
    EXPECT_FALSE(gyro.turned(at(900), at(1300)));
    EXPECT_NEAR(gyro.turned(at(1500), at(1520)).value(), 0.02, 1e-9);
    gyro.forgetBefore(at(1510));
    EXPECT_NEAR(gyro.turned(at(1510), at(1520)).value(), 0.01, 1e-9);
    EXPECT_FALSE(gyro.turned(at(900), at(1000)));
}

TEST(TurnGyro, NonsenseAndClocksThatJumpAreNoEnd) {
    TurnGyro gyro = rising(0, 1000);
    gyro.add(at(1010), std::numeric_limits<double>::quiet_NaN());
    gyro.add(at(1010), std::numeric_limits<double>::infinity());
    gyro.add(at(500), 99.0);  // out of order
    EXPECT_NEAR(gyro.turned(at(0), at(1000)).value(), 0.5, 1e-9);
    gyro.add(at(3'600'000), 1.0);
    for (int ms = 1020; ms <= 1100; ms += 20) gyro.add(at(ms), 1.0);
    EXPECT_NEAR(gyro.turned(at(1020), at(1100)).value(), 0.08, 1e-9);
}

}  // namespace
}  // namespace leitstand
