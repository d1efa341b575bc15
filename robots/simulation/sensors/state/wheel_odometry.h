#pragma once

#include <string>
#include <vector>

#include "core/event/motion_samples.h"
#include "robots/simulation/sensors/schedule.h"
#include "robots/simulation/sensors/sensor.h"
#include "robots/simulation/sensors/state/inertial_unit.h"

namespace leitstand::simulation {

/// Adds up how far wheels or chains turn, along the attitude from an inertial unit. Slip is not measured and
/// makes the distance too long. The heading does not change while the wheels stand.
class DeadReckoning {
public:
    /// Adds one step: how far each side has turned since the last step [m].
    void step(double left, double right, const MeasuredAttitude& attitude);
    [[nodiscard]] const Pose& pose() const { return m_pose; }
    [[nodiscard]] double distance() const { return m_distance; }  ///< total distance, mean of both sides [m]

private:
    Pose m_pose = Pose::Identity();
    double m_heading = 0.0, m_lastHeading = 0.0;  ///< own heading, and last heading of the unit [rad]
    double m_distance = 0.0;
};

struct OdometrySettings {
    double rate = 20.0, mostRate = 50.0;  ///< default rate, and the highest that can be requested [Hz]
    std::string odomFrame, baseFrame;
};

/// Odometry from wheels and gyro, as a message and as a transform of base_link in odom.
class WheelOdometry final : public Sensor {
public:
    /// @p unit must be run before this sensor, and must outlive it.
    WheelOdometry(const OdometrySettings& settings, const InertialUnit& unit, Time start);

    void run(const World& world, int robot, std::vector<HardwareSample>& samples) override;
    bool configure(StreamRole role, const std::string& sensor, const StreamSettings& settings) override;

private:
    struct Encoders {
        Time at{};
        double left = 0.0, right = 0.0;  ///< how far each side has turned since the beginning [m]
    };
    [[nodiscard]] OdometrySample sampleOf(const MeasuredAttitude& attitude, const BodyState& state) const;

    OdometrySettings m_settings;
    const InertialUnit& m_unit;
    Schedule m_schedule;
    bool m_odometryEnabled = true, m_transformsEnabled = true, m_begun = false;
    Encoders m_before;    ///< as read in the last run
    Encoders m_reported;  ///< as read in the last step
    DeadReckoning m_reckoning;
};

}  // namespace leitstand::simulation
