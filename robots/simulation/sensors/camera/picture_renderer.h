#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "robots/simulation/sensors/camera/camera_model.h"
#include "robots/simulation/sensors/camera/light_field.h"
#include "robots/simulation/sensors/noise.h"
#include "robots/simulation/sensors/ray_caster.h"

namespace leitstand::simulation {

/// Returns the directions of all pixels of a camera, row by row, in its frame; zero where it sees nothing.
[[nodiscard]] std::vector<Eigen::Vector3f> pixelDirections(const CameraModel& camera);

/// Exposure, vignetting and noise of a camera.
struct ExposureSettings {
    float brightness = 0.42F;  ///< mean brightness that its pictures are adjusted to, 0 to 1
    float leastGain = 0.6F, mostGain = 5.0F;
    float adaption = 0.15F;    ///< share of the difference to the right gain that is corrected per picture
    float vignetting = 0.30F;  ///< how much darker corners are, 0 to 1
    float noise = 0.006F;      ///< noise of a pixel (0 to 1) at gain 1, standard deviation
};

/// Draws what a camera sees, with one ray per pixel and one shadow ray per two pixels. Pictures have
/// textures, light of the hall and of lamps, automatic gain, darker corners and noise.
class PictureRenderer {
public:
    PictureRenderer(const CameraModel& camera, const Noise& noise, const ExposureSettings& settings = {});

    /// Sets another picture size or calibration; the exposure is kept.
    void setCamera(const CameraModel& camera);
    [[nodiscard]] const CameraModel& camera() const { return m_camera; }

    /// Returns the pixels (bgr8, row by row) of what is seen from @p cameraInArena (optical frame). They are
    /// valid until the next call.
    [[nodiscard]] const std::vector<std::uint8_t>& render(const Pose& cameraInArena, const CastRays& cast,
                                                          const LightField& light);

private:
    void castRow(const Pose& cameraInArena, int row, const CastRays& cast);
    void castShadows(const CastRays& cast);
    [[nodiscard]] float sunnyAt(std::size_t column) const;  ///< for a column of the row that was cast last
    void develop();

    CameraModel m_camera;
    Noise m_noise;
    ExposureSettings m_settings;
    float m_gain = 0.0F;  ///< 0: no picture was taken yet
    std::vector<Eigen::Vector3f> m_directions;
    std::vector<float> m_vignette;
    std::vector<Eigen::Vector3f> m_light;  ///< light of each pixel: red, green, blue, linear
    std::vector<Ray> m_rays;               ///< rays of one row
    std::vector<Hit> m_hits;
    std::vector<Ray> m_shadowRays;
    std::vector<Hit> m_shadowHits;
    std::vector<std::uint8_t> m_pixels;
};

}  // namespace leitstand::simulation
