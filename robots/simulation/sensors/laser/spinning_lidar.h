#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <vector>

#include "core/event/cloud_sample.h"
#include "robots/simulation/sensors/laser/laser_head.h"
#include "robots/simulation/sensors/schedule.h"
#include "robots/simulation/sensors/sensor.h"

namespace leitstand::simulation {

/// Settings and mounting of a lidar that spins about its z axis.
struct SpinningLidarSettings {
    LaserSettings laser;
    int rings = 16, columns = 900;
    /// Elevation of the lowest ring, and angle between rings [rad].
    double lowest = degrees(-15.0), ringStep = degrees(2.0);
    double rate = 10.0;  ///< revolutions [Hz]
    std::string sensor, frame;
    Pose lidarInBase = Pose::Identity();
};

/// Velodyne VLP-16: 16 rings over 30 degrees at 10 Hz, 0.5 to 100 m, standard deviation 1 cm (user manual
/// 63-9243). Thinned to every other shot: 0.4 degrees apart.
[[nodiscard]] SpinningLidarSettings vlp16();

/// A lidar that sends a cloud for each revolution, as velodyne_pointcloud does: unorganised, without points
/// that have no echo. The stamp is that of the last shot; the times of points are relative to it.
class SpinningLidar final : public Sensor {
public:
    SpinningLidar(const SpinningLidarSettings& settings, const Noise& noise, Time start);

    void run(const World& world, int robot, std::vector<HardwareSample>& samples) override;
    bool configure(StreamRole role, const std::string& sensor, const StreamSettings& settings) override;

private:
    [[nodiscard]] std::chrono::nanoseconds shotAfter(int column) const;
    [[nodiscard]] std::size_t indexOf(int ring, int column) const;  ///< index in m_rays
    [[nodiscard]] CloudSample revolution(const World& world, int robot, Time start);

    SpinningLidarSettings m_settings;
    LaserHead m_head;
    Schedule m_schedule;
    bool m_enabled = true;
    std::vector<Ray> m_rays;  ///< ring by ring, so that neighbouring rays see similar surfaces
};

}  // namespace leitstand::simulation
