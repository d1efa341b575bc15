#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/event/cloud_sample.h"
#include "robots/simulation/sensors/laser/laser_head.h"
#include "robots/simulation/sensors/schedule.h"
#include "robots/simulation/sensors/sensor.h"

namespace leitstand::simulation {

/// Settings and mounting of a lidar that spins about its z axis.
struct SpinningLidarSettings {
    /// How its beams move.
    enum class Pattern : std::uint8_t {
        Rings,    ///< each at its elevation, once around
        Rosette,  ///< up and down while they go around twice; the next revolution looks between
    };
    /// What is sent where there was no echo.
    enum class NoEcho : std::uint8_t {
        Nothing,  ///< the cloud is unorganised
        Zeros,    ///< a point at the scanner's own place; of rings, the cloud is organised
    };
    /// To which shot the stamp belongs.
    enum class Stamp : std::uint8_t { First, Last };

    LaserSettings laser;
    Pattern pattern = Pattern::Rings;
    NoEcho noEcho = NoEcho::Nothing;
    Stamp stamp = Stamp::Last;
    int rings = 16, columns = 900;
    /// Elevation of the lowest ring, and angle between rings [rad]; of a rosette, between the lowest and the
    /// highest beam.
    double lowest = degrees(-15.0), ringStep = degrees(2.0);
    double rate = 10.0;  ///< revolutions [Hz]
    std::string sensor, frame;
    Pose lidarInBase = Pose::Identity();
};

/// Velodyne VLP-16: 16 rings over 30 degrees at 10 Hz, 0.5 to 100 m, standard deviation 1 cm (user manual
/// 63-9243). Thinned to every other shot: 0.4 degrees apart.
[[nodiscard]] SpinningLidarSettings vlp16();
/// Ouster OS1-32 in its mode 512x10: 32 rings over 45 degrees (data sheet). Its driver, ouster_ros, sends
/// organised clouds, and zeros without an echo; the stamp is that of the first shot.
[[nodiscard]] SpinningLidarSettings os1();
/// Livox Mid-360: four beams from -7 to 52 degrees, 0.1 to 40 m, all around in a pattern that does not repeat
/// (user manual). The pattern itself is not published; this one has a tenth of its 200,000 points a second in
/// each revolution, halved. Its driver, livox_ros_driver2, sends zeros without an echo and stamps the first.
[[nodiscard]] SpinningLidarSettings mid360();

/// A lidar that sends a cloud for each revolution, as velodyne_pointcloud, ouster_ros and livox_ros_driver2
/// do. The times of points are relative to the stamp.
class SpinningLidar final : public Sensor {
public:
    SpinningLidar(const SpinningLidarSettings& settings, const Noise& noise, Time start);

    void run(const World& world, int robot, std::vector<HardwareSample>& samples) override;
    bool configure(StreamRole role, const std::string& sensor, const StreamSettings& settings) override;

private:
    [[nodiscard]] std::chrono::nanoseconds shotAfter(int column) const;
    [[nodiscard]] std::size_t indexOf(int ring, int column) const;          ///< index in m_rays
    [[nodiscard]] Eigen::Vector3d directionOf(int ring, int column) const;  ///< in the lidar's frame
    [[nodiscard]] CloudSample revolution(const World& world, int robot, Time start);

    SpinningLidarSettings m_settings;
    LaserHead m_head;
    Schedule m_schedule;
    bool m_enabled = true;
    std::int64_t m_revolutions = 0;
    std::vector<Ray> m_rays;  ///< ring by ring, so that neighbouring rays see similar surfaces
};

}  // namespace leitstand::simulation
