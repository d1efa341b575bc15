#pragma once

#include <string>
#include <vector>

#include "robots/simulation/sensors/camera/camera_model.h"
#include "robots/simulation/sensors/noise.h"
#include "robots/simulation/sensors/schedule.h"
#include "robots/simulation/sensors/sensor.h"

namespace leitstand::simulation {

/// Settings of a stereo camera that sends depths.
struct DepthCameraSettings {
    CameraModel model;
    double rate = 5.0;                       ///< [Hz]
    double nearest = 0.35, farthest = 12.0;  ///< depths that it tells [m]
    double deviation = 0.005;                ///< standard deviation at 1 m; it grows with the square [m]
    std::string sensor, frame;
    Pose cameraInBase = Pose::Identity();  ///< pose of the optical frame
};

/// Stereo pair of an OAK-D: 7.5 cm apart, 73 degrees across (data sheet), thinned to 320 x 200.
[[nodiscard]] DepthCameraSettings oakD();

/// A camera that sends pictures of depths (16UC1, millimetres along its axis; REP 118) on its stream of
/// points, and its calibration.
class DepthCamera final : public Sensor {
public:
    DepthCamera(const DepthCameraSettings& settings, const Noise& noise, Time start);

    void run(const World& world, int robot, std::vector<HardwareSample>& samples) override;
    bool configure(StreamRole role, const std::string& sensor, const StreamSettings& settings) override;

private:
    DepthCameraSettings m_settings;
    Noise m_noise;
    Schedule m_schedule;
    bool m_enabled = true;
    std::vector<Eigen::Vector3f> m_directions;  ///< of the pixels, row by row, unit length
};

}  // namespace leitstand::simulation
