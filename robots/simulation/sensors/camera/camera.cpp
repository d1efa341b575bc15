#include "robots/simulation/sensors/camera/camera.h"

#include <algorithm>
#include <utility>

#include "core/event/stream_role.h"
#include "robots/simulation/sensors/camera/picture_file_writing.h"

namespace leitstand::simulation {

Camera::Camera(CameraSettings settings, std::shared_ptr<SharedLight> light, const Noise& noise, Time start)
    : m_settings(std::move(settings)),
      m_light(std::move(light)),
      m_renderer(m_settings.model, noise, m_settings.exposure),
      m_schedule(m_settings.rate, start),
      m_quality(m_settings.quality) {}

void Camera::run(const World& world, int robot, std::vector<HardwareSample>& samples) {
    const auto stamp = m_schedule.newest(world.now());
    if (!stamp) return;
    const SampleHeader header{*stamp, m_settings.frame};
    if (m_enabled && (!m_settings.mayDraw || m_settings.mayDraw(m_settings.sensor))) {
        const Pose cameraInArena = world.baseInArena(robot, *stamp) * m_settings.cameraInBase(*stamp);
        const CastRays cast = castInto(world.scene(), RayKind::Camera, m_settings.seesRobot ? -1 : robot);
        const auto& pixels = m_renderer.render(cameraInArena, cast, m_light->of(world.scene()));
        const CameraModel& model = m_renderer.camera();
        PictureSample picture;
        picture.header = header;
        picture.compressed = true;
        picture.encoding = "jpeg";
        picture.content = jpegFile(pixels, model.width, model.height, m_quality);
        samples.push_back({StreamRole::Picture, m_settings.sensor, std::move(picture)});
    }
    if (m_infoEnabled) {
        samples.push_back({StreamRole::CameraInfo, m_settings.sensor, m_renderer.camera().info(header)});
    }
}

bool Camera::configure(StreamRole role, const std::string& sensor, const StreamSettings& settings) {
    if (sensor != m_settings.sensor) return false;
    if (role == StreamRole::CameraInfo) {
        m_infoEnabled = settings.enabled;
        return true;
    }
    if (role != StreamRole::Picture) return false;
    m_enabled = settings.enabled;
    m_quality = settings.quality > 0 ? std::min(settings.quality, 100) : m_settings.quality;
    m_schedule.setRate(settings.rate > 0.0 ? std::min(settings.rate, m_settings.mostRate) : m_settings.rate);
    const CameraModel wanted = m_settings.model.scaledTo(settings.maxWidth);
    if (wanted.width != m_renderer.camera().width) m_renderer.setCamera(wanted);
    return true;
}

}  // namespace leitstand::simulation
