#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "robots/simulation/sensors/camera/picture_renderer.h"
#include "robots/simulation/sensors/schedule.h"
#include "robots/simulation/sensors/sensor.h"

namespace leitstand::simulation {

/// Returns the pose in base_link of a sensor that can be turned, at a recent time.
using MountAt = std::function<Pose(Time)>;

/// Light of a world, which is computed when a camera first needs it.
class SharedLight {
public:
    [[nodiscard]] const LightField& of(const Scene& scene) {
        if (m_field == nullptr) m_field = std::make_unique<LightField>(scene);
        return *m_field;
    }

private:
    std::unique_ptr<LightField> m_field;
};

/// Settings of a camera and of its stream.
struct CameraSettings {
    CameraModel model;
    ExposureSettings exposure;
    double rate = 10.0, mostRate = 15.0;  ///< default rate, and the highest that can be requested [Hz]
    int quality = 70;                     ///< quality of JPEG
    bool seesRobot = false;               ///< whether the robot itself is in the picture
    std::string sensor, frame;
    MountAt cameraInBase;  ///< pose of the optical frame
    /// Called before each picture; empty: pictures are always drawn.
    std::function<bool(std::string_view sensor)> mayDraw = {};
};

/// A camera that sends JPEG pictures and its calibration.
class Camera final : public Sensor {
public:
    Camera(CameraSettings settings, std::shared_ptr<SharedLight> light, const Noise& noise, Time start);

    void run(const World& world, int robot, std::vector<HardwareSample>& samples) override;
    bool configure(StreamRole role, const std::string& sensor, const StreamSettings& settings) override;

private:
    CameraSettings m_settings;
    std::shared_ptr<SharedLight> m_light;
    PictureRenderer m_renderer;
    Schedule m_schedule;
    int m_quality;
    bool m_enabled = true, m_infoEnabled = true;
};

}  // namespace leitstand::simulation
