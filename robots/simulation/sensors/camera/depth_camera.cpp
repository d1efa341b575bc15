#include "robots/simulation/sensors/camera/depth_camera.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>
#include <utility>

#include "core/event/picture_samples.h"
#include "core/event/stream_role.h"
#include "robots/simulation/sensors/ray_caster.h"

namespace leitstand::simulation {

DepthCameraSettings oakD() {
    DepthCameraSettings settings;
    CameraModel& model = settings.model;
    model.width = 320;
    model.height = 200;
    model.fx = model.fy = 160.0 / std::tan(degrees(36.5));
    model.cx = 159.5;
    model.cy = 99.5;
    return settings;
}

DepthCamera::DepthCamera(const DepthCameraSettings& settings, const Noise& noise, Time start)
    : m_settings(settings), m_noise(noise), m_schedule(settings.rate, start) {
    const CameraModel& model = m_settings.model;
    for (int y = 0; y < model.height; ++y) {
        for (int x = 0; x < model.width; ++x) {
            const auto direction = model.direction({x, y});
            m_directions.push_back(direction ? Eigen::Vector3f(direction->cast<float>())
                                             : Eigen::Vector3f(Eigen::Vector3f::Zero()));
        }
    }
}

void DepthCamera::run(const World& world, int robot, std::vector<HardwareSample>& samples) {
    const auto stamp = m_schedule.newest(world.now());
    if (!stamp) return;
    const CameraModel& model = m_settings.model;
    const SampleHeader header{*stamp, m_settings.frame};
    samples.push_back({StreamRole::CameraInfo, m_settings.sensor, model.info(header)});
    if (!m_enabled) return;
    const Pose camera = world.baseInArena(robot, *stamp) * m_settings.cameraInBase;
    std::vector<Ray> rays(m_directions.size());
    std::vector<Hit> hits(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
        rays[i].origin = camera.translation().cast<float>();
        rays[i].direction = camera.linear().cast<float>() * m_directions[i];
    }
    castInto(world.scene(), RayKind::Camera, robot)(rays, hits);
    auto pixels = std::make_shared<std::vector<std::byte>>(rays.size() * sizeof(std::uint16_t));
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (!hits[i].there()) continue;
        const double along = static_cast<double>(hits[i].distance * m_directions[i].z());
        const double depth = along + m_settings.deviation * along * along * m_noise.normal();
        if (depth < m_settings.nearest || depth > m_settings.farthest) continue;
        const auto millimetres = static_cast<std::uint16_t>(std::lround(depth * 1e3));
        std::memcpy(pixels->data() + i * sizeof(millimetres), &millimetres, sizeof(millimetres));
    }
    PictureSample picture;
    picture.header = header;
    picture.encoding = "16UC1";
    picture.width = model.width;
    picture.height = model.height;
    picture.step = static_cast<std::size_t>(model.width) * sizeof(std::uint16_t);
    picture.bigEndian = std::endian::native == std::endian::big;
    picture.content = {pixels, *pixels};
    samples.push_back({StreamRole::Points, m_settings.sensor, std::move(picture)});
}

bool DepthCamera::configure(StreamRole role, const std::string& sensor, const StreamSettings& settings) {
    if (sensor != m_settings.sensor || role != StreamRole::Points) return false;
    m_enabled = settings.enabled;
    return true;
}

}  // namespace leitstand::simulation
