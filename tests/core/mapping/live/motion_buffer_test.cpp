#include "core/mapping/motion/motion_buffer.h"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "core/event/motion_samples.h"
#include "tests/core/mapping/live/slices.h"

namespace leitstand::test {
namespace {

using std::chrono::milliseconds;

Time at(int ms) {
    return Time(std::chrono::seconds(100) + milliseconds(ms));
}

Pose moving(int ms) {
    return poseFrom({0.5e-3 * ms, 0, 0}, 0, 0, degrees(0.03) * ms);
}

TEST(MotionBuffer, AnInertialUnitAloneFillsNoMemory) {
    MotionBuffer buffer;
    ImuSample imu;
    imu.orientation = Eigen::Quaterniond::Identity();
    const Time begin(std::chrono::seconds(1'000));
    for (int i = 0; i < 3000; ++i) {
        imu.header.stamp = begin + i * std::chrono::milliseconds(100);
        buffer.add(imu, Pose::Identity());
    }
    EXPECT_TRUE(buffer.up(imu.header.stamp));
    EXPECT_TRUE(buffer.up(imu.header.stamp - MotionBuffer::Memory / 2));
    EXPECT_FALSE(buffer.up(begin)) << "five minutes ago";
}

TEST(MotionBuffer, TellsMeasuredBridgedAndExtrapolated) {
    MotionBuffer buffer;
    EXPECT_FALSE(buffer.at(at(0)));
    for (int ms = 0; ms <= 1000; ms += 50) buffer.add(odometryAt(at(ms), moving(ms)));
    const auto between = buffer.at(at(525));
    ASSERT_TRUE(between);
    EXPECT_EQ(between->source, MotionSource::Measured);
    EXPECT_TRUE(between->baseInOdom.isApprox(moving(525), 1e-4));
    const auto ahead = buffer.at(at(1100));
    ASSERT_TRUE(ahead);
    EXPECT_EQ(ahead->source, MotionSource::Extrapolated);
    EXPECT_LT(distanceBetween(ahead->baseInOdom, moving(1100)), 0.005);
    EXPECT_LT(angleBetween(ahead->baseInOdom, moving(1100)), degrees(0.1));
    EXPECT_FALSE(buffer.at(at(1600))) << "too far ahead";
    EXPECT_FALSE(buffer.covers(at(1001)));
    for (int ms = 3000; ms <= 4000; ms += 50) buffer.add(odometryAt(at(ms), moving(ms)));
    EXPECT_EQ(buffer.at(at(2000))->source, MotionSource::Bridged);
}

/// Says that the robot turns by @p rate [rad/s] from @p from to @p to [ms], by a unit that lies on its side.
void turn(MotionBuffer& buffer, int from, int to, double rate) {
    const Pose unitInBase = poseFrom({0.1, 0, 0.2}, degrees(90), 0, 0);
    ImuSample imu;
    imu.linearAcceleration = unitInBase.linear().transpose() * Eigen::Vector3d(0, 0, 9.81);
    imu.angularVelocity = unitInBase.linear().transpose() * Eigen::Vector3d(0, 0, rate);
    for (int ms = from; ms <= to; ms += 20) {
        imu.header.stamp = at(ms);
        buffer.add(imu, unitInBase);
    }
}

double headingAt(const MotionBuffer& buffer, int ms) {
    const Eigen::Vector3d ahead = buffer.at(at(ms))->baseInOdom.linear().col(0);
    return inDegrees(std::atan2(ahead.y(), ahead.x()));
}

TEST(MotionBuffer, TheGyrosTellHowItTurnedBeyondItsOdometry) {
    MotionBuffer buffer;
    for (int ms = 0; ms <= 1000; ms += 20)
        buffer.add(odometryAt(at(ms), poseFrom({0.5e-3 * ms, 0, 0}, 0, 0, 0)));
    EXPECT_NEAR(headingAt(buffer, 1300), 0.0, 1e-6) << "as it moved last";
    turn(buffer, 0, 1000, 0.0);
    turn(buffer, 1020, 1300, degrees(60));  // it begins to turn as the odometry falls silent
    EXPECT_NEAR(headingAt(buffer, 1300), 17.4, 0.5);
    EXPECT_EQ(buffer.at(at(1300))->source, MotionSource::Extrapolated);
    EXPECT_NEAR(buffer.at(at(1300))->baseInOdom.translation().head<2>().norm(), 0.65, 0.01)
        << "and drives on";
}

TEST(MotionBuffer, TheGyrosTellHowItTurnedInAGapOfTheOdometry) {
    MotionBuffer buffer;
    const auto stand = [&](int from, int to, double heading) {
        for (int ms = from; ms <= to; ms += 20)
            buffer.add(odometryAt(at(ms), poseFrom({1, 2, 0}, 0, 0, degrees(heading))));
    };
    stand(0, 1000, 170);
    turn(buffer, 0, 2000, degrees(1));  // so much they drift
    turn(buffer, 2020, 3000, degrees(61));
    turn(buffer, 3020, 5000, degrees(1));
    stand(5000, 6000, 230);
    EXPECT_EQ(buffer.at(at(2500))->source, MotionSource::Bridged);
    EXPECT_NEAR(headingAt(buffer, 2000), 170.0, 1.0) << "it did not turn yet";
    EXPECT_NEAR(headingAt(buffer, 2500), 200.0 - 360.0, 2.0);
    EXPECT_NEAR(headingAt(buffer, 4000), 230.0 - 360.0, 1.0);
    EXPECT_EQ(buffer.at(at(2500))->baseInOdom.translation(), Eigen::Vector3d(1, 2, 0));
}

TEST(MotionBuffer, StrayStampsAndPosesThatAreNoneAreLeftOut) {
    MotionBuffer buffer;
    for (int ms = 0; ms <= 1000; ms += 50) {
        buffer.add(odometryAt(at(ms), moving(ms)));
        if (ms == 500) buffer.add(odometryAt(Time{}, moving(ms)));
        if (ms == 600) buffer.add(odometryAt(at(90'000), moving(ms)));
        OdometrySample broken = odometryAt(at(ms + 10), moving(ms));
        broken.baseInOdom.translation().x() = std::numeric_limits<double>::quiet_NaN();
        buffer.add(broken);
    }
    EXPECT_EQ(buffer.clockJumps(), 0);
    EXPECT_FALSE(buffer.covers(at(2000)));
    EXPECT_TRUE(buffer.at(at(725))->baseInOdom.isApprox(moving(725), 1e-4));
}

TEST(MotionBuffer, TellsHowFarItWentToAndFro) {
    MotionBuffer buffer;
    for (int ms = 0; ms <= 2000; ms += 50) {
        const int there = ms <= 1000 ? ms : 2000 - ms;
        buffer.add(odometryAt(at(ms), moving(there)));
    }
    const Travel travel = buffer.travelled(at(0), at(2000));
    EXPECT_NEAR(travel.way, 1.0, 0.05);
    EXPECT_NEAR(travel.turn, degrees(60), degrees(3));
    EXPECT_EQ(buffer.travelled(at(2000), at(0)).way, 0.0);
}

TEST(MotionBuffer, DisorderIsNoJump) {
    MotionBuffer buffer;
    for (const int ms : {0, 50, 150, 100, 250, 300, 200, 350}) buffer.add(odometryAt(at(ms), moving(ms)));
    EXPECT_EQ(buffer.clockJumps(), 0);
    EXPECT_TRUE(buffer.at(at(225))->baseInOdom.isApprox(moving(225), 1e-4));
}

TEST(LevelFilter, IsCalmerThanTheUnitAndFollowsARamp) {
    // The error of the unit's level is another one every two seconds; the gyro is noisy, too.
    std::mt19937 random(1);
    std::normal_distribution<double> normal;
    LevelFilter filter;
    double error = 0.0, worstUnit = 0.0, worst = 0.0, worstOnRamp = 0.0;
    const auto pitchAt = [](double time) { return degrees(15) * std::clamp((time - 40.0) / 0.4, 0.0, 1.0); };
    for (int i = 0; i < 1200; ++i) {
        const double time = 0.05 * i, pitch = pitchAt(time);
        error = std::exp(-0.025) * error + degrees(0.25) * std::sqrt(1.0 - std::exp(-0.05)) * normal(random);
        const Eigen::Vector3d up =
            poseFrom({0, 0, 0}, 0, pitch + error, 0).linear().transpose() * Eigen::Vector3d::UnitZ();
        const double rate = (pitchAt(time + 1e-3) - pitchAt(time - 1e-3)) / 2e-3;
        filter.add(at(50 * i), up, Eigen::Vector3d(0, rate + degrees(0.2) * normal(random), 0));
        const auto level = filter.at(at(50 * i));
        ASSERT_TRUE(level);
        const double off = std::abs(std::asin(-level->x()) - pitch);
        if (time > 10.0 && time < 40.0) {
            worstUnit = std::max(worstUnit, std::abs(error));
            worst = std::max(worst, off);
        }
        if (time > 40.0) worstOnRamp = std::max(worstOnRamp, off);
    }
    EXPECT_LT(worst, 0.7 * worstUnit);
    EXPECT_LT(inDegrees(worstOnRamp), 1.0);
}

/// What a unit at rest says, pitched by @p pitch.
void rest(MotionBuffer& buffer, int from, int to, double pitch) {
    ImuSample imu;
    imu.orientation = Eigen::Quaterniond(poseFrom({0, 0, 0}, 0, pitch, 0).linear());
    for (int ms = from; ms < to; ms += 50) {
        imu.header.stamp = at(ms);
        buffer.add(imu, Pose::Identity());
    }
}

TEST(LevelFilter, OneStampOfTheFutureIsLeftOut) {
    for (const int ahead : {2'000, 60'000, 3'600'000}) {
        MotionBuffer buffer;
        rest(buffer, 0, 5'000, degrees(10));
        rest(buffer, 5'000 + ahead, 5'001 + ahead, 0.0);
        rest(buffer, 5'000, 8'000, degrees(10));
        const auto up = buffer.up(at(7'900));
        ASSERT_TRUE(up) << ahead;
        EXPECT_NEAR(inDegrees(std::asin(-up->x())), 10.0, 0.1) << ahead;
        EXPECT_TRUE(ahead < 5'000 || buffer.up(at(2'000))) << "what was measured before stays";
    }
}

TEST(LevelFilter, AUnitWhoseClockWasSetGoesOn) {
    for (const int jump : {-80'000, -3'000, 3'000, 3'600'000}) {
        MotionBuffer buffer;
        rest(buffer, 0, 5'000, degrees(10));
        rest(buffer, 5'000 + jump, 8'000 + jump, degrees(-5));
        const auto up = buffer.up(at(7'900 + jump));
        ASSERT_TRUE(up) << jump;
        EXPECT_NEAR(inDegrees(std::asin(-up->x())), -5.0, 0.1) << jump;
    }
}

TEST(LevelFilter, TakesGravityWhereThereIsNoOrientation) {
    MotionBuffer buffer;
    ImuSample imu;
    for (int ms = 0; ms < 1000; ms += 50) {
        imu.header.stamp = at(ms);
        imu.linearAcceleration = Eigen::Vector3d(0, 0, 9.81);
        buffer.add(imu, Pose::Identity());
    }
    EXPECT_TRUE(buffer.up(at(975))->isApprox(Eigen::Vector3d::UnitZ()));
    EXPECT_FALSE(buffer.up(at(2000)));
}

}  // namespace
}  // namespace leitstand::test
