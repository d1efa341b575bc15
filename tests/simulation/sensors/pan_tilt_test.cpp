#include <gtest/gtest.h>

#include "robots/simulation/sensors/pan_tilt.h"

namespace leitstand::simulation {
namespace {

using namespace std::chrono_literals;
constexpr Time Start{std::chrono::seconds(1'000'000)};

TEST(PanTilt, TurnsAtItsSpeedAndStopsAtTheTarget) {
    PanTilt unit({}, Start);
    unit.setTarget(degrees(60), degrees(-12));
    unit.advance(Start + 250ms);
    EXPECT_NEAR(inDegrees(unit.at(Start + 250ms).pan), 30.0, 1e-9);
    EXPECT_NEAR(inDegrees(unit.at(Start + 125ms).pan), 15.0, 1e-9) << "between two advances";
    EXPECT_NEAR(inDegrees(unit.at(Start + 250ms).tilt), -12.0, 1e-9);
    EXPECT_NEAR(inDegrees(unit.velocity().pan), 120.0, 1e-9);
    unit.advance(Start + 900ms);
    EXPECT_NEAR(inDegrees(unit.at(Start + 900ms).pan), 60.0, 1e-9);
    unit.advance(Start + 1s);
    EXPECT_EQ(unit.velocity().pan, 0.0);
}

TEST(PanTilt, StaysWithinItsLimitsAndTakesNoNonsense) {
    PanTilt unit({}, Start);
    unit.setTarget(10.0, -10.0);
    unit.setTarget(std::nan(""), std::nan(""));
    unit.advance(Start + 10s);
    EXPECT_NEAR(inDegrees(unit.at(Start + 10s).pan), 100.0, 1e-9);
    EXPECT_NEAR(inDegrees(unit.at(Start + 10s).tilt), -60.0, 1e-9);
    unit.setTarget(0.0, 10.0);
    unit.advance(Start + 20s);
    EXPECT_NEAR(inDegrees(unit.at(Start + 20s).tilt), 50.0, 1e-9);
}

TEST(PanTilt, LooksLeftByPanAndDownByTilt) {
    PanTilt unit({}, Start);
    unit.setTarget(degrees(90), degrees(30));
    unit.advance(Start + 5s);
    const Eigen::Vector3d ahead = unit.platform(Start + 5s).linear() * Eigen::Vector3d::UnitX();
    EXPECT_TRUE(ahead.isApprox(Eigen::Vector3d(0, std::cos(degrees(30)), -0.5), 1e-9)) << ahead;
}

}  // namespace
}  // namespace leitstand::simulation
