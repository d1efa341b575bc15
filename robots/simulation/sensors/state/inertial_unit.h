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
    double rate = 20.0, mostRate = 100.0;  ///< default rate, and the highest that can be requested [Hz]
    double bias = degrees(0.02);           ///< standard deviation of the gyro's initial error [rad/s]
    double biasWalk = degrees(0.002);  ///< standard deviation of the change of this error in a second [rad/s]
    double scaleError = 0.004;         ///< standard deviation of the error of the gyro's scale
    double rateNoise = degrees(0.2);   ///< noise of the angular velocity, standard deviation [rad/s]
    double levelError = degrees(0.25);  ///< slowly changing error of roll and pitch, standard deviation [rad]
    double accelerationNoise = 0.05;    ///< noise of the acceleration, standard deviation [m/s2]
    std::string sensor, frame;
    Pose unitInBase = Pose::Identity();
};

/// Attitude as the unit estimates it: roll and pitch from gravity, heading from the gyro alone, starting at
/// 0.
struct MeasuredAttitude {
    Time stamp{};
    double roll = 0.0, pitch = 0.0, heading = 0.0;      ///< attitude of base_link [rad]
    Eigen::Vector3d angular = Eigen::Vector3d::Zero();  ///< angular velocity in base_link [rad/s]
};

/// Three gyros and accelerometers. The heading drifts; roll and pitch do not.
class InertialUnit final : public Sensor {
public:
    InertialUnit(const InertialSettings& settings, const Noise& noise, Time start);

    void run(const World& world, int robot, std::vector<HardwareSample>& samples) override;
    bool configure(StreamRole role, const std::string& sensor, const StreamSettings& settings) override;

    /// Returns the attitudes in the last run(), measured 100 times a second.
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
    Eigen::Vector3d m_lastVelocity = Eigen::Vector3d::Zero();  ///< in the arena's frame [m/s]
    Eigen::Vector3d m_acceleration = Eigen::Vector3d::Zero();  ///< in base_link, including gravity [m/s2]
    std::vector<MeasuredAttitude> m_attitudes;
};

}  // namespace leitstand::simulation
