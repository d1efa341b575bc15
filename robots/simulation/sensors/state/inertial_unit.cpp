#include "robots/simulation/sensors/state/inertial_unit.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

#include "core/base/rotation/heading.h"
#include "core/base/time.h"
#include "core/event/motion_samples.h"
#include "core/event/stream_role.h"

namespace leitstand::simulation {
namespace {

constexpr double TickRate = 100.0;   ///< [Hz]
constexpr double LevelChange = 2.0;  ///< time constant of the errors of roll and pitch [s]
constexpr double Gravity = 9.81;     ///< [m/s2]

Eigen::Matrix3d rotationOf(double roll, double pitch, double yaw) {
    return poseFrom(Eigen::Vector3d::Zero(), roll, pitch, yaw).linear();
}

std::array<double, 9> diagonal(double xy, double z) {
    return {xy, 0.0, 0.0, 0.0, xy, 0.0, 0.0, 0.0, z};
}

}  // namespace

InertialUnit::InertialUnit(const InertialSettings& settings, const Noise& noise, Time start)
    : m_settings(settings), m_noise(noise), m_ticks(TickRate, start), m_schedule(settings.rate, start) {
    m_bias = settings.bias * m_noise.normal();
    m_gain = 1.0 + settings.scaleError * m_noise.normal();
}

MeasuredAttitude InertialUnit::measure(const Pose& baseInArena, Time stamp) {
    constexpr double Tick = 1.0 / TickRate;
    const Eigen::Matrix3d& rotation = baseInArena.linear();
    const Eigen::AngleAxisd turned(m_lastPose.linear().transpose() * rotation);
    const Eigen::Vector3d angular = turned.axis() * turned.angle() / Tick;
    const double yaw =
        std::remainder(headingOf(rotation) - headingOf(m_lastPose.linear()), 2.0 * std::numbers::pi);
    m_lastPose = baseInArena;

    m_bias += m_settings.biasWalk * std::sqrt(Tick) * m_noise.normal();
    m_heading = std::remainder(m_heading + m_gain * yaw + m_bias * Tick, 2.0 * std::numbers::pi);
    const double kept = std::exp(-Tick / LevelChange);
    const double fresh = m_settings.levelError * std::sqrt(1.0 - kept * kept);
    m_rollError = kept * m_rollError + fresh * m_noise.normal();
    m_pitchError = kept * m_pitchError + fresh * m_noise.normal();

    MeasuredAttitude measured;
    measured.stamp = stamp;
    measured.roll = std::atan2(rotation(2, 1), rotation(2, 2)) + m_rollError;
    measured.pitch = std::asin(std::clamp(-rotation(2, 0), -1.0, 1.0)) + m_pitchError;
    measured.heading = m_heading;
    measured.angular = m_gain * angular + Eigen::Vector3d(0.0, 0.0, m_bias);
    return measured;
}

void InertialUnit::feelAcceleration(const World& world, int robot) {
    const BodyState& state = world.state(robot);
    const Eigen::Matrix3d& rotation = state.baseInArena.linear();
    const Eigen::Vector3d velocity = rotation * state.linear;
    const double seconds = toSeconds(world.now() - m_lastRun);
    Eigen::Vector3d inArena(0.0, 0.0, Gravity);
    if (m_begun && seconds > 0.0) inArena += (velocity - m_lastVelocity) / seconds;
    if (!m_begun || seconds > 0.0) m_acceleration = rotation.transpose() * inArena;
    m_lastVelocity = velocity;
    m_lastRun = world.now();
}

ImuSample InertialUnit::sampleOf(const MeasuredAttitude& attitude) {
    const Eigen::Matrix3d unitInBase = m_settings.unitInBase.linear();
    const auto noise = [this] {
        return Eigen::Vector3d(m_noise.normal(), m_noise.normal(), m_noise.normal());
    };
    ImuSample sample;
    sample.header = {attitude.stamp, m_settings.frame};
    sample.orientation =
        Eigen::Quaterniond(rotationOf(attitude.roll, attitude.pitch, attitude.heading) * unitInBase)
            .normalized();
    sample.angularVelocity = unitInBase.transpose() * (attitude.angular + m_settings.rateNoise * noise());
    sample.linearAcceleration =
        unitInBase.transpose() * (m_acceleration + m_settings.accelerationNoise * noise());
    const auto squared = [](double value) { return value * value; };
    sample.orientationCovariance = diagonal(squared(m_settings.levelError), squared(degrees(5.0)));
    sample.angularVelocityCovariance = diagonal(squared(m_settings.rateNoise), squared(m_settings.rateNoise));
    sample.linearAccelerationCovariance =
        diagonal(squared(m_settings.accelerationNoise), squared(m_settings.accelerationNoise));
    return sample;
}

void InertialUnit::run(const World& world, int robot, std::vector<HardwareSample>& samples) {
    m_attitudes.clear();
    feelAcceleration(world, robot);
    while (const auto tick = m_ticks.due(world.now())) {
        const Pose base = world.baseInArena(robot, *tick);
        if (!m_begun) m_lastPose = base;
        m_begun = true;
        m_attitudes.push_back(measure(base, *tick));
        while (const auto stamp = m_schedule.due(*tick)) {
            if (!m_enabled) continue;
            samples.push_back({StreamRole::Imu, m_settings.sensor, sampleOf(m_attitudes.back())});
        }
    }
}

bool InertialUnit::configure(StreamRole role, const std::string& sensor, const StreamSettings& settings) {
    if (role != StreamRole::Imu || sensor != m_settings.sensor) return false;
    m_enabled = settings.enabled;
    m_schedule.setRate(settings.rate > 0.0 ? std::min(settings.rate, m_settings.mostRate) : m_settings.rate);
    return true;
}

}  // namespace leitstand::simulation
