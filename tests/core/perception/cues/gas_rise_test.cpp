#include "core/perception/cues/gas_rise.h"

#include <chrono>
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace leitstand::test {
namespace {

/// A sensor of 1 Hz with a lag of 10 s and noise.
class Sensor {
public:
    std::optional<GasRise> breathe(double truth) {
        m_level += (truth - m_level) * (1.0 - std::exp(-0.1));
        m_time += std::chrono::seconds(1);
        std::normal_distribution<double> noise(0.0, 8.0 + 0.01 * m_level);
        return watch.add(m_time, m_level + noise(m_random));
    }
    GasWatch watch;

private:
    Time m_time{std::chrono::seconds(1000)};
    double m_level = 420.0;
    std::mt19937 m_random{5};
};

TEST(GasRise, CleanAirIsNone) {
    Sensor sensor;
    for (int i = 0; i < 600; ++i) EXPECT_FALSE(sensor.breathe(420.0).has_value()) << i;
}

TEST(GasRise, TellsABreathWhileItIsThereAndNotWhileTheSensorRecovers) {
    Sensor sensor;
    for (int i = 0; i < 30; ++i) (void)sensor.breathe(420.0);
    std::optional<GasRise> rise;
    int reported = 0;
    for (int i = 0; i < 40; ++i) {
        if ((rise = sensor.breathe(900.0))) ++reported;
    }
    ASSERT_TRUE(rise);
    EXPECT_NEAR(rise->rise(), 480.0, 60.0);
    EXPECT_GT(reported, 25);
    for (int i = 0; i < 8; ++i) (void)sensor.breathe(420.0);
    for (int i = 0; i < 40; ++i) EXPECT_FALSE(sensor.breathe(420.0).has_value()) << i;
}

TEST(GasRise, StrangeSamplesAreLeftOut) {
    GasWatch watch;
    const Time begin(std::chrono::seconds(1000));
    EXPECT_FALSE(watch.add(begin, std::numeric_limits<double>::quiet_NaN()));
    EXPECT_FALSE(watch.add(begin, -5.0));
    EXPECT_FALSE(watch.newest());
    EXPECT_FALSE(watch.add(begin, 420.0));
    EXPECT_FALSE(watch.add(begin, 9000.0)) << "the same stamp";
    EXPECT_NEAR(watch.newest()->level, 420.0, 1e-9);
    EXPECT_FALSE(watch.add(Time(std::chrono::seconds(1)), 500.0)) << "the clock began anew";
    EXPECT_NEAR(watch.newest()->level, 500.0, 1e-9);
}

TEST(GasRise, TheStrongerTheNearer) {
    EXPECT_GT(breathReach(120.0), breathReach(400.0));
    EXPECT_NEAR(breathReach(3000.0), 0.4, 1e-9);
    EXPECT_EQ(breathReach(0.0), 0.0);
    EXPECT_EQ(breathReach(1e9), 0.0);
}

}  // namespace
}  // namespace leitstand::test
