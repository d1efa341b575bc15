#include "app/session/coverage/view_finder.h"

#include <algorithm>
#include <utility>
#include <variant>

namespace leitstand {
namespace {

constexpr std::size_t MostWaiting = 60;
constexpr std::chrono::milliseconds LongestWait(500);  ///< of a picture for odometry

Time stampOf(const Event& event, const SampleHeader& header) {
    return header.stamp == Time{} ? event.received : header.stamp;
}

}  // namespace

ViewFinder::ViewFinder(const RobotDescription& robot)
    : m_robot(robot), m_frames(m_robot), m_tracker(robot.name) {}

std::vector<FoundView> ViewFinder::found() {
    return std::exchange(m_found, {});
}

void ViewFinder::correct(const MapFix& fix) {
    m_fix = fix;
    follow();
}

void ViewFinder::lose() {
    m_fix.reset();
    m_tracker.lose();
}

void ViewFinder::follow() {
    // A guessed motion would turn the robot in the map until the next fix.
    if (!m_fix || !m_tracker.motion().covers(m_fix->stamp)) return;
    m_tracker.correct(*m_fix);
    m_fix.reset();
}

void ViewFinder::take(const Event& event) {
    m_frames.add(event);
    if (const auto* odometry = std::get_if<OdometrySample>(&event.sample)) {
        m_tracker.add(*odometry, event.received);
        follow();
        look(event.received);
    } else if (const auto* imu = std::get_if<ImuSample>(&event.sample)) {
        const auto unit = m_frames.inBase(event.sensor, imu->header.frame, imu->header.stamp);
        if (unit) m_tracker.add(*imu, *unit, event.received);
    } else if (const auto* info = std::get_if<CameraInfoSample>(&event.sample)) {
        m_cameras[event.sensor].field = fieldOf(*info);
    } else if (const auto* picture = std::get_if<PictureSample>(&event.sample)) {
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
        if (!m_tracker.motion().covers(first.stamp) && now - first.received < LongestWait) return;
        look(first);
        m_waiting.pop_front();
    }
}

void ViewFinder::look(const Waiting& picture) {
    Camera& camera = m_cameras[picture.sensor];
    const auto inBase = m_frames.inBase(picture.sensor, picture.frame, picture.stamp);
    const auto motion = m_tracker.motion().at(picture.stamp);
    if (!inBase || !motion || !camera.field) return;
    const Pose inOdom = motion->baseInOdom * *inBase;
    bool blurred = false;
    if (camera.before && picture.stamp > camera.beforeAt) {
        const double since = std::chrono::duration<double>(picture.stamp - camera.beforeAt).count();
        blurred = angleBetween(*camera.before, inOdom) > Fastest * std::max(1e-3, since);
    }
    camera.before = inOdom;
    camera.beforeAt = picture.stamp;
    // What is seen from a place that is in doubt may be somewhere else.
    const auto baseInMap = m_tracker.baseInMap(picture.stamp);
    if (blurred || !baseInMap || !m_tracker.now().certain) return;
    m_found.push_back({picture.kind, *baseInMap * *inBase, *camera.field});
}

}  // namespace leitstand
