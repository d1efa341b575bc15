#include "app/services/coverage/view_search.h"

#include <utility>

#include "core/event/event.h"
#include "core/event/motion_samples.h"
#include "core/event/picture_samples.h"
#include "core/event/sample.h"
#include "core/event/scan_pose.h"

namespace leitstand {
namespace {

template <class... Samples>
bool isAnyOf(const Sample& sample) {
    return (sample.is<Samples>() || ...);
}

}  // namespace

ViewSearch::ViewSearch(const std::vector<RobotDescription>& robots) {
    for (const RobotDescription& robot : robots) m_finders.try_emplace(robot.name, robot);
}

bool ViewSearch::wants(const Event& event) {
    return KeyScanPlaces::wants(event) ||
           isAnyOf<OdometrySample, ImuSample, TransformsSample, CameraInfoSample, PictureSample>(
               event.sample);
}

std::vector<SearchView> ViewSearch::found() {
    return std::exchange(m_found, {});
}

void ViewSearch::correct(std::span<const PlaceOfRobot> fixes) {
    for (const PlaceOfRobot& one : fixes) correct(one.robot, one.fix);
}

void ViewSearch::lose(const std::string& robot) {
    const auto finder = m_finders.find(robot);
    if (finder != m_finders.end()) finder->second.lose();
}

void ViewSearch::correct(const std::string& robot, const MapFix& fix) {
    const auto finder = m_finders.find(robot);
    if (finder != m_finders.end()) finder->second.correct(fix);
}

void ViewSearch::follow(std::span<const ScanPose> poses) {
    correct(m_scans.follow(poses));
}

void ViewSearch::onEvent(const Event& event) {
    if (KeyScanPlaces::wants(event)) return correct(m_scans.onEvent(event));
    const auto finder = m_finders.find(event.robot);
    if (finder == m_finders.end()) return;
    finder->second.onEvent(event);
    for (const FoundView& view : finder->second.found()) {
        const std::uint64_t scan = m_scans.scanFor(event.robot, view.opticalInMap.translation());
        if (scan == 0) continue;
        m_found.push_back({.scan = scan,
                           .sensor = view.sensor,
                           .cameraInScan = m_scans.scanInMap(scan).inverse() * view.opticalInMap,
                           .field = view.field,
                           .seen = event.received});
    }
}

}  // namespace leitstand
