#include "app/services/coverage/view_finder.h"

#include <algorithm>
#include <utility>

#include "core/base/time.h"
#include "core/event/event.h"
#include "core/event/motion_samples.h"
#include "core/event/picture_samples.h"
#include "core/event/stream_role.h"

namespace leitstand {
namespace {

constexpr std::size_t MostWaiting = 60;
constexpr std::chrono::milliseconds LongestWait(500);  ///< that a picture waits for odometry

}  // namespace

ViewFinder::ViewFinder(const RobotDescription& robot) : m_robot(robot), m_places(m_robot) {}

std::vector<FoundView> ViewFinder::found() {
    return std::exchange(m_found, {});
}

void ViewFinder::onEvent(const Event& event) {
    m_places.onEvent(event);
    if (event.sample.is<OdometrySample>()) {
        look(event.received);
    } else if (const auto* info = event.sample.as<CameraInfoSample>()) {
        m_cameras[event.sensor].field = fieldOf(*info);
    } else if (const auto* picture = event.sample.as<PictureSample>()) {
        const bool thermal = event.role == StreamRole::Thermal;
        if (!thermal && event.role != StreamRole::Picture) return;
        Camera& camera = m_cameras[event.sensor];
        const Time stamp = stampOf(event, picture->header);
        if (stamp >= camera.taken && stamp - camera.taken < Every) return;
        if (m_waiting.size() >= MostWaiting) return;
        camera.taken = stamp;
        m_waiting.push_back({event.sensor, picture->header.frame,
                             thermal ? SearchSensor::Infrared : SearchSensor::Camera, stamp, event.received});
    }
}

void ViewFinder::look(Time now) {
    while (!m_waiting.empty()) {
        const Waiting& first = m_waiting.front();
        if (!m_places.covers(first.stamp) && now - first.received < LongestWait) return;
        look(first);
        m_waiting.pop_front();
    }
}

void ViewFinder::look(const Waiting& picture) {
    Camera& camera = m_cameras[picture.sensor];
    const auto place = m_places.at(picture.sensor, picture.frame, picture.stamp);
    if (!place || !camera.field) return;
    const Pose inOdom = place->sensorInOdom();
    bool blurred = false;
    if (camera.before && picture.stamp > camera.beforeAt) {
        const double since = toSeconds(picture.stamp - camera.beforeAt);
        blurred = angleBetween(*camera.before, inOdom) > Fastest * std::max(1e-3, since);
    }
    camera.before = inOdom;
    camera.beforeAt = picture.stamp;
    // A view from a doubtful place may show somewhere else.
    if (blurred || !place->baseInMap || !place->certain) return;
    m_found.push_back({picture.kind, *place->baseInMap * place->sensorInBase, *camera.field});
}

}  // namespace leitstand
