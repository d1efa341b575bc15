#include "app/services/places/key_scan_places.h"

#include <limits>

#include "core/event/event.h"
#include "core/event/map_samples.h"
#include "core/event/scan_pose.h"
#include "core/mapping/placement/placement_format.h"

namespace leitstand {

PlaceOfRobot KeyScanPlaces::Scan::fix(double certainty) const {
    return {robot,
            {end, scanInMap * sensorInBase.inverse(), certainty, counts,
             counts ? logged(placement_format::FitsMap) : logged(placement_format::DoesNotFit)}};
}

bool KeyScanPlaces::wants(const Event& event) {
    return event.sample.is<KeyScanSample>() || event.sample.is<ScanPosesSample>() ||
           event.sample.is<RobotPlaceSample>();
}

std::vector<PlaceOfRobot> KeyScanPlaces::onEvent(const Event& event) {
    std::vector<PlaceOfRobot> fixes;
    if (const auto* sample = event.sample.as<KeyScanSample>()) {
        if (!sample->scan) return fixes;
        const Scan scan{sample->scan->robot, sample->scan->end, sample->sensorInBase, sample->scanInMap,
                        true};
        m_scans[sample->id] = scan;
        m_newest[scan.robot] = sample->id;
        fixes.push_back(scan.fix(1.0));
    } else if (const auto* poses = event.sample.as<ScanPosesSample>()) {
        for (const ScanPose& pose : poses->poses) move(pose, fixes);
    } else if (const auto* place = event.sample.as<RobotPlaceSample>()) {
        fixes.push_back({place->robot,
                         {place->measured, place->baseInMap, place->certainty, place->certain, place->how}});
    }
    return fixes;
}

void KeyScanPlaces::move(const ScanPose& pose, std::vector<PlaceOfRobot>& fixes) {
    Scan& scan = m_scans[pose.scan];
    scan.scanInMap = pose.scanInMap;
    scan.counts = pose.trust == ScanTrust::Certain;
    const auto newest = m_newest.find(scan.robot);
    if (newest != m_newest.end() && newest->second == pose.scan) fixes.push_back(scan.fix(pose.certainty));
}

std::vector<PlaceOfRobot> KeyScanPlaces::follow(std::span<const ScanPose> poses) {
    std::vector<PlaceOfRobot> fixes;
    for (auto& [id, scan] : m_scans) scan.counts = false;
    for (const ScanPose& pose : poses) move(pose, fixes);
    return fixes;
}

std::uint64_t KeyScanPlaces::scanFor(const std::string& robot, const Eigen::Vector3d& place) const {
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

}  // namespace leitstand
