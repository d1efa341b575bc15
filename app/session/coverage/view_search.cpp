#include "app/session/coverage/view_search.h"

#include <limits>
#include <utility>
#include <variant>

namespace leitstand {
namespace {

template <class... Samples>
bool isAnyOf(const Sample& sample) {
    return (std::holds_alternative<Samples>(sample) || ...);
}

}  // namespace

ViewSearch::ViewSearch(const std::vector<RobotDescription>& robots) {
    for (const RobotDescription& robot : robots) m_finders.try_emplace(robot.name, robot);
}

bool ViewSearch::wants(const Event& event) {
    return isAnyOf<OdometrySample, ImuSample, TransformsSample, CameraInfoSample, PictureSample,
                   KeyScanSample, ScanPosesSample, RobotPlaceSample>(event.sample);
}

std::vector<SearchView> ViewSearch::found() {
    return std::exchange(m_found, {});
}

void ViewSearch::correct(const Scan& scan, double certainty) {
    correct(scan.robot, {scan.end, scan.scanInMap * scan.sensorInBase.inverse(), certainty, scan.counts, {}});
}

void ViewSearch::lose(const std::string& robot) {
    const auto finder = m_finders.find(robot);
    if (finder != m_finders.end()) finder->second.lose();
}

void ViewSearch::correct(const std::string& robot, const MapFix& fix) {
    const auto finder = m_finders.find(robot);
    if (finder != m_finders.end()) finder->second.correct(fix);
}

void ViewSearch::move(const ScanPose& pose) {
    Scan& scan = m_scans[pose.scan];  // of an earlier session: without a robot
    scan.scanInMap = pose.scanInMap;
    scan.counts = pose.trust == ScanTrust::Certain;
    const auto newest = m_newest.find(scan.robot);
    if (newest != m_newest.end() && newest->second == pose.scan) correct(scan, pose.certainty);
}

void ViewSearch::follow(std::span<const ScanPose> poses) {
    for (const ScanPose& pose : poses) move(pose);
}

std::uint64_t ViewSearch::scanFor(const std::string& robot, const Eigen::Vector3d& place) const {
    const auto own = m_newest.find(robot);
    if (own != m_newest.end() && m_scans.at(own->second).counts) return own->second;
    std::uint64_t best = 0;
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& [id, scan] : m_scans) {
        const double away = (scan.scanInMap.translation() - place).norm();
        if (!scan.counts || away >= nearest) continue;
        nearest = away;
        best = id;
    }
    return best;
}

void ViewSearch::take(const Event& event) {
    if (const auto* sample = std::get_if<KeyScanSample>(&event.sample)) {
        if (!sample->scan) return;
        const Scan scan{sample->scan->robot, sample->scan->end, sample->sensorInBase, sample->scanInMap,
                        true};
        m_scans[sample->id] = scan;
        m_newest[scan.robot] = sample->id;
        return correct(scan, 1.0);
    }
    if (const auto* poses = std::get_if<ScanPosesSample>(&event.sample)) return follow(poses->poses);
    if (const auto* place = std::get_if<RobotPlaceSample>(&event.sample)) {
        return correct(place->robot,
                       {place->measured, place->baseInMap, place->certainty, place->certain, place->how});
    }
    const auto finder = m_finders.find(event.robot);
    if (finder == m_finders.end()) return;
    finder->second.take(event);
    for (const FoundView& view : finder->second.found()) {
        const std::uint64_t scan = scanFor(event.robot, view.opticalInMap.translation());
        if (scan == 0) continue;
        m_found.push_back({.scan = scan,
                           .sensor = view.sensor,
                           .cameraInScan = m_scans.at(scan).scanInMap.inverse() * view.opticalInMap,
                           .field = view.field});
    }
}

}  // namespace leitstand
