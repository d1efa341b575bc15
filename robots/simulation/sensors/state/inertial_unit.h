#pragma once

#include <string>
#include <vector>

#include "core/event/motion_samples.h"
#include "robots/simulation/sensors/noise.h"
#include "robots/simulation/sensors/schedule.h"
#include "robots/simulation/sensors/sensor.h"

namespace leitstand::simulation {

/// Rates and errors of an inertial unit.
struct InertialSettings {
    double rate = 20.0, mostRate = 100.0;  ///< default, and the highest that can be requested [Hz]
    double bias = degrees(0.02);           ///< deviation of the gyro's error at the beginning [rad/s]
    double biasWalk = degrees(0.002);      ///< deviation of its change in a second [rad/s]
    double scaleError = 0.004;             ///< deviation of the gyro's gain
    double rateNoise = degrees(0.2);       ///< of the angular velocity [rad/s]
    double levelError = degrees(0.25);     ///< of roll and pitch, slowly changing [rad]
    double accelerationNoise = 0.05;       ///< [m/s2]
    std::string sensor, frame;
    Pose unitInBase = Pose::Identity();
};

/// Attitude as the unit estimates it: roll and pitch by gravity, heading by the gyro alone, from 0 at the
/// beginning.
struct MeasuredAttitude {
    Time stamp{};
    double roll = 0.0, pitch = 0.0, heading = 0.0;      ///< of base_link [rad]
    Eigen::Vector3d angular = Eigen::Vector3d::Zero();  ///< in base_link [rad/s]
};

/// Three gyros and accelerometers: the heading drifts, roll and pitch do not.
class InertialUnit final : public Sensor {
public:
    InertialUnit(const InertialSettings& settings, const Noise& noise, Time start);

    void run(const World& world, int robot, std::vector<HardwareSample>& samples) override;
    bool configure(StreamRole role, const std::string& sensor, const StreamSettings& settings) override;

    /// Returns the attitudes of the last run(), measured 100 times a second.
    [[nodiscard]] const std::vector<MeasuredAttitude>& attitudes() const { return m_attitudes; }

private:
    [[nodiscard]] MeasuredAttitude measure(const Pose& baseInArena, Time stamp);
    [[nodiscard]] ImuSample sampleOf(const MeasuredAttitude& attitude);
    void feelAcceleration(const World& world, int robot);

    InertialSettings m_settings;
    Noise m_noise;
    Schedule m_ticks, m_schedule;
    bool m_enabled = true, m_begun = false;
    double m_bias, m_gain;
    double m_rollError = 0.0, m_pitchError = 0.0, m_heading = 0.0;  ///< [rad]
    Pose m_lastPose = Pose::Identity();
    Time m_lastRun{};
    Eigen::Vector3d m_lastVelocity = Eigen::Vector3d::Zero();  ///< arena's frame [m/s]
    Eigen::Vector3d m_acceleration = Eigen::Vector3d::Zero();  ///< in base_link, with gravity [m/s2]
    std::vector<MeasuredAttitude> m_attitudes;
};

}  // namespace leitstand::simulation
