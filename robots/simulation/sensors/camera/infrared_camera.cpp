#include "robots/simulation/sensors/camera/infrared_camera.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/event/stream_role.h"
#include "robots/simulation/sensors/camera/picture_file_writing.h"

namespace leitstand::simulation {
namespace {

constexpr double ZeroCelsius = 273.15;  ///< [K]
constexpr float Nearest = 0.02F;        ///< [m]
constexpr float BehindFoil = 0.005F;    ///< [m]

double radiance(double kelvin) {
    return kelvin * kelvin * kelvin * kelvin;  // Stefan-Boltzmann, without its constant
}

bool letsThrough(const Hit& hit) {
    return hit.there() && propertiesOf(hit.surface->material).infraredTransmission > 0.0F;
}

}  // namespace

double apparentTemperature(const Hit& hit, const Hit* behind, double ambient) {
    if (!hit.there()) return ambient;
    const MaterialProperties& material = propertiesOf(hit.surface->material);
    const double through = behind == nullptr ? 0.0 : material.infraredTransmission;
    const double emitted = std::min<double>(material.emissivity, 1.0 - through);
    const double mirrored = 1.0 - emitted - through;
    double light = emitted * radiance(hit.surface->temperature) + mirrored * radiance(ambient);
    if (behind != nullptr) light += through * radiance(apparentTemperature(*behind, nullptr, ambient));
    return std::sqrt(std::sqrt(light));
}

InfraredCamera::InfraredCamera(InfraredSettings settings, const Noise& noise, Time start)
    : m_settings(std::move(settings)), m_noise(noise), m_schedule(m_settings.rate, start) {
    setCamera(m_settings.model);
}

void InfraredCamera::setCamera(const CameraModel& model) {
    m_model = model;
    m_directions = pixelDirections(model);
    m_rays.resize(m_directions.size());
    m_hits.resize(m_directions.size());
    m_pixels.resize(m_directions.size());
}

void InfraredCamera::castBehindFoil(const CastRays& cast) {
    m_behindOf.assign(m_rays.size(), -1);
    m_behindRays.clear();
    for (std::size_t i = 0; i < m_rays.size(); ++i) {
        if (!letsThrough(m_hits[i])) continue;
        m_behindOf[i] = static_cast<int>(m_behindRays.size());
        m_behindRays.push_back(m_rays[i]);
        m_behindRays.back().near = m_hits[i].distance + BehindFoil;
    }
    m_behindHits.resize(m_behindRays.size());
    if (!m_behindRays.empty()) cast(m_behindRays, m_behindHits);
}

void InfraredCamera::render(const Pose& cameraInArena, const CastRays& cast, double ambient) {
    const Eigen::Matrix3f turn = cameraInArena.linear().cast<float>();
    const Eigen::Vector3f origin = cameraInArena.translation().cast<float>();
    for (std::size_t i = 0; i < m_rays.size(); ++i) {
        m_rays[i] = {origin, turn * m_directions[i], Nearest, 100.0F};
    }
    cast(m_rays, m_hits);
    castBehindFoil(cast);
    for (std::size_t i = 0; i < m_rays.size(); ++i) {
        const Hit* behind =
            m_behindOf[i] < 0 ? nullptr : &m_behindHits[static_cast<std::size_t>(m_behindOf[i])];
        const double kelvin = apparentTemperature(m_hits[i], behind, ambient) +
                              m_settings.noise * double{m_noise.quickNormal()};
        const double measured = std::round(kelvin / m_settings.step) * m_settings.step;
        const double number = std::round((measured - m_settings.offset) / m_settings.scale);
        m_pixels[i] = static_cast<std::uint16_t>(std::clamp(number, 0.0, 65535.0));
    }
}

void InfraredCamera::run(const World& world, int robot, std::vector<HardwareSample>& samples) {
    const auto stamp = m_schedule.newest(world.now());
    if (!stamp) return;
    const SampleHeader header{*stamp, m_settings.frame};
    if (m_enabled && (!m_settings.mayDraw || m_settings.mayDraw(m_settings.sensor))) {
        const Pose cameraInArena = world.baseInArena(robot, *stamp) * m_settings.cameraInBase(*stamp);
        render(cameraInArena, castInto(world.scene(), RayKind::Infrared, robot),
               world.arena().ambient + ZeroCelsius);
        PictureSample picture;
        picture.header = header;
        picture.compressed = true;
        picture.encoding = "png";
        picture.content = pngFile(m_pixels, m_model.width, m_model.height);
        samples.push_back({StreamRole::Thermal, m_settings.sensor, std::move(picture)});
    }
    if (m_infoEnabled) {
        samples.push_back({StreamRole::CameraInfo, m_settings.sensor, m_model.info(header)});
    }
}

bool InfraredCamera::configure(StreamRole role, const std::string& sensor, const StreamSettings& settings) {
    if (sensor != m_settings.sensor) return false;
    if (role == StreamRole::CameraInfo) {
        m_infoEnabled = settings.enabled;
        return true;
    }
    if (role != StreamRole::Thermal) return false;
    m_enabled = settings.enabled;
    m_schedule.setRate(settings.rate > 0.0 ? std::min(settings.rate, m_settings.rate) : m_settings.rate);
    const CameraModel wanted = m_settings.model.scaledTo(settings.maxWidth);
    if (wanted.width != m_model.width) setCamera(wanted);
    return true;
}

}  // namespace leitstand::simulation
