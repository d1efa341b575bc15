#include "tests/simulation/mapping/scripted_motion.h"

#include <algorithm>
#include <cmath>

#include "robots/simulation/sensors/noise.h"
#include "robots/simulation/sensors/state/inertial_unit.h"
#include "robots/simulation/sensors/state/wheel_odometry.h"

namespace leitstand::simulation::test {
namespace {

constexpr double Standing = 3.0;      ///< before the drive [s]
constexpr double GainingSpeed = 1.0;  ///< [s]
constexpr double Step = 0.05;         ///< between samples [s]
constexpr double LevelChange = 2.0;   ///< as of the simulated inertial unit [s]
constexpr double Gravity = 9.81;      ///< [m/s2]

/// The simulated inertial unit's errors, on poses instead of a world.
class Attitudes {
public:
    Attitudes(std::uint64_t seed, const Pose& first)
        : m_noise(seed, "scripted imu"),
          m_last(first),
          m_bias(m_settings.bias * m_noise.normal()),
          m_gain(1.0 + m_settings.scaleError * m_noise.normal()) {}

    ImuSample measure(const Pose& base, Time stamp) {
        const Eigen::Matrix3d& rotation = base.linear();
        const Eigen::AngleAxisd turned(m_last.linear().transpose() * rotation);
        const Eigen::Vector3d velocity = (base.translation() - m_last.translation()) / Step;
        const Eigen::Vector3d inArena = (velocity - m_velocity) / Step + Gravity * Eigen::Vector3d::UnitZ();
        m_velocity = velocity;
        m_last = base;
        m_bias += m_settings.biasWalk * std::sqrt(Step) * m_noise.normal();
        const double kept = std::exp(-Step / LevelChange);
        const double fresh = m_settings.levelError * std::sqrt(1.0 - kept * kept);
        m_rollError = kept * m_rollError + fresh * m_noise.normal();
        m_pitchError = kept * m_pitchError + fresh * m_noise.normal();
        m_roll = std::atan2(rotation(2, 1), rotation(2, 2)) + m_rollError;
        m_pitch = std::asin(std::clamp(-rotation(2, 0), -1.0, 1.0)) + m_pitchError;
        ImuSample sample;
        sample.header = {stamp, "imu"};
        const double yaw = std::atan2(rotation(1, 0), rotation(0, 0));
        sample.orientation =
            Eigen::Quaterniond(poseFrom(Eigen::Vector3d::Zero(), m_roll, m_pitch, yaw).linear());
        sample.angularVelocity = m_gain * turned.axis() * turned.angle() / Step +
                                 Eigen::Vector3d(0.0, 0.0, m_bias) + m_settings.rateNoise * noise();
        sample.linearAcceleration = rotation.transpose() * inArena + m_settings.accelerationNoise * noise();
        return sample;
    }
    [[nodiscard]] double roll() const { return m_roll; }
    [[nodiscard]] double pitch() const { return m_pitch; }

private:
    Eigen::Vector3d noise() {
        const double x = m_noise.normal(), y = m_noise.normal();
        return {x, y, m_noise.normal()};
    }
    InertialSettings m_settings;
    Noise m_noise;
    Pose m_last;
    Eigen::Vector3d m_velocity = Eigen::Vector3d::Zero();
    double m_bias, m_gain;
    double m_rollError = 0.0, m_pitchError = 0.0, m_roll = 0.0, m_pitch = 0.0;
};

}  // namespace

ScriptedMotion::ScriptedMotion(const DrivePath& path, const ScriptSettings& settings)
    : m_path(path),
      m_speed(settings.speed),
      m_length(std::min(settings.longest, path.length())),
      m_duration(Standing + GainingSpeed / 2 + m_length / settings.speed) {}

double ScriptedMotion::way(double seconds) const {
    const double moving = seconds - Standing;
    if (moving <= 0.0) return 0.0;
    const double gained = std::min(moving, GainingSpeed);
    const double way = m_speed * (gained * gained / (2 * GainingSpeed) + (moving - gained));
    return std::min(way, m_length);
}

Pose ScriptedMotion::baseAt(Time stamp) const {
    return baseAt(std::chrono::duration<double>(stamp - ScriptBegin).count());
}

MotionSamples motionSamples(const ScriptedMotion& motion, const OdometryErrors& errors, std::uint64_t seed) {
    MotionSamples samples;
    Noise noise(seed, "scripted odometry");
    Attitudes attitudes(seed, motion.baseAt(0.0));
    DeadReckoning reckoning;
    const auto yawOf = [](const Pose& pose) { return std::atan2(pose.linear()(1, 0), pose.linear()(0, 0)); };
    double way = 0.0, heading = 0.0, lastYaw = yawOf(motion.baseAt(0.0));
    const int steps = static_cast<int>(motion.duration() / Step) + 20;  // a second more: scans wait for it
    for (int i = 0; i <= steps; ++i) {
        const double seconds = i * Step;
        const Time stamp = ScriptBegin + std::chrono::milliseconds(50 * i);
        const Pose base = motion.baseAt(seconds);
        samples.imu.push_back(attitudes.measure(base, stamp));
        const double gone = motion.way(seconds) - way, yaw = yawOf(base);
        way += gone;
        heading += std::remainder(yaw - lastYaw, 2.0 * 3.14159265358979323846) + errors.headingBias * gone +
                   errors.headingNoise * std::sqrt(gone) * noise.normal();
        lastYaw = yaw;
        // The path is level; uphill, wheels turn more.
        const double rise = base.linear()(2, 0), slope = 1.0 / std::sqrt(std::max(0.5, 1.0 - rise * rise));
        const double reported = gone * slope * (1.0 + errors.scale + errors.wayNoise * noise.normal());
        MeasuredAttitude attitude;
        attitude.stamp = stamp;
        attitude.roll = attitudes.roll();
        attitude.pitch = attitudes.pitch();
        attitude.heading = heading;
        reckoning.step(reported, reported, attitude);
        OdometrySample sample;
        sample.header = {stamp, "odom"};
        sample.childFrame = "base_link";
        sample.baseInOdom = reckoning.pose();
        sample.linear.x() = reported / Step;
        samples.odometry.push_back(std::move(sample));
    }
    return samples;
}

}  // namespace leitstand::simulation::test
