#include <cstddef>
#include <vector>

#include "app/services/mapping/live_mapping.h"

namespace leitstand {

bool scansMoved(const LiveMapPtr& before, const LiveMap& after) {
    if (!before) return false;
    // Scans are only ever added, at the end.
    for (std::size_t i = 0; i < before->scans.size() && i < after.scans.size(); ++i) {
        const ScanPose &was = before->scans[i].pose, &is = after.scans[i].pose;
        const bool aside = was.trust == ScanTrust::SetAside, asideNow = is.trust == ScanTrust::SetAside;
        if (aside != asideNow || was.scanInMap.matrix() != is.scanInMap.matrix()) return true;
    }
    return false;
}

void LiveMapping::layTrails() {
    for (auto& [name, robot] : m_robots) {
        std::vector<TrailAnchor> anchors;
        for (const LiveKeyScan& one : m_map->scans) {
            const Scan& scan = *one.scan;
            if (scan.robot != name || !scan.hasOdometry || one.odometryFrame < 0) continue;
            if (one.pose.trust == ScanTrust::SetAside) continue;
            anchors.push_back(
                {scan.end, one.odometryFrame, one.pose.scanInMap * scan.sensorInOdom.inverse()});
        }
        if (!anchors.empty()) robot.tracker.layTrail(anchors);
    }
}

void LiveMapping::carryAlong() {
    if (!m_map) return;
    const MovedPlaces places(*m_map, *m_mapper.map());
    if (!places.any()) return;
    for (auto& [name, robot] : m_robots) {
        if (!robot.tracker.placed() || m_mapper.fix(name)) continue;
        robot.tracker.move(places);
        robot.laser.mapMoved();
    }
}

}  // namespace leitstand
