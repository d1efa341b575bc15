#pragma once

#include <string>
#include <vector>

#include "core/event/cloud_sample.h"
#include "robots/simulation/sensors/laser/laser_head.h"
#include "robots/simulation/sensors/schedule.h"
#include "robots/simulation/sensors/sensor.h"

namespace leitstand::simulation {

/// Settings and mounting of a plane laser scanner.
struct PlaneLaserSettings {
    LaserSettings laser;
    int points = 667;
    double first = degrees(-119.88);  ///< angle of the first shot about z [rad]
    double step = degrees(0.36);      ///< angle between shots [rad]
    double rate = 10.0;               ///< turns of the mirror [Hz]
    std::string sensor, frame;
    Pose laserInBase = Pose::Identity();
};

/// Hokuyo URG: 240 degrees, 4 m, 10 Hz, 0.36 degrees, deviation 5 mm + 1 %.
[[nodiscard]] PlaneLaserSettings hokuyoUrg();

/// Slamtec RPLIDAR A1M8: all directions, 0.15 to 12 m, 8,000 shots and 7.5 turns per second. The standard
/// deviation is 1 % of the range (data sheet, rev. 2.3).
[[nodiscard]] PlaneLaserSettings rplidarA1();

/// A laser that scans its own xy plane.
class PlaneLaser final : public Sensor {
public:
    PlaneLaser(const PlaneLaserSettings& settings, const Noise& noise, Time start);

    void run(const World& world, int robot, std::vector<HardwareSample>& samples) override;
    bool configure(StreamRole role, const std::string& sensor, const StreamSettings& settings) override;

private:
    [[nodiscard]] std::chrono::nanoseconds shotAfter(int point) const;
    [[nodiscard]] RangesSample turn(const World& world, int robot, Time stamp);

    PlaneLaserSettings m_settings;
    LaserHead m_head;
    Schedule m_schedule, m_sent;  ///< turns of the mirror, and turns that are sent
    bool m_enabled = true;
    std::vector<Ray> m_rays;
};

}  // namespace leitstand::simulation
