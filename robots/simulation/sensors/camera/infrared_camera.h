#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "robots/simulation/sensors/camera/camera.h"

namespace leitstand::simulation {

/// Settings of an infrared camera and of its stream.
struct InfraredSettings {
    CameraModel model;
    double rate = 9.0;    ///< default and highest rate [Hz]
    double noise = 0.1;   ///< noise of a pixel, standard deviation [K]
    double step = 0.04;   ///< step of its converter, which keeps pictures small [K]
    double scale = 0.01;  ///< kelvin per step of the pixel values [K]
    double offset = 0.0;  ///< kelvin at pixel value 0 [K]
    std::string sensor, frame;
    MountAt cameraInBase;  ///< pose of the optical frame
    /// Called before each picture; empty: pictures are always drawn.
    std::function<bool(std::string_view sensor)> mayDraw = {};
};

/// Returns the temperature that an infrared camera shows for @p hit [K]; the camera assumes that everything
/// is a black body. @p behind: what is behind a foil that was hit; null: nothing shines through. @p ambient:
/// temperature of reflected surroundings, and of a ray that hits nothing [K].
[[nodiscard]] double apparentTemperature(const Hit& hit, const Hit* behind, double ambient);

/// A camera that measures temperatures and publishes them as 16-bit PNG, by default in centikelvin.
class InfraredCamera final : public Sensor {
public:
    InfraredCamera(InfraredSettings settings, const Noise& noise, Time start);

    void run(const World& world, int robot, std::vector<HardwareSample>& samples) override;
    bool configure(StreamRole role, const std::string& sensor, const StreamSettings& settings) override;

private:
    void setCamera(const CameraModel& model);
    void render(const Pose& cameraInArena, const CastRays& cast, double ambient);
    void castBehindFoil(const CastRays& cast);

    InfraredSettings m_settings;
    CameraModel m_model;
    Noise m_noise;
    Schedule m_schedule;
    bool m_enabled = true, m_infoEnabled = true;
    std::vector<Eigen::Vector3f> m_directions;
    std::vector<Ray> m_rays, m_behindRays;
    std::vector<Hit> m_hits, m_behindHits;
    std::vector<int> m_behindOf;  ///< index in m_behindHits for each ray; -1: no foil
    std::vector<std::uint16_t> m_pixels;
};

}  // namespace leitstand::simulation
