#include "core/mapping/live/map/cropped_scans.h"

#include <utility>
#include <vector>

#include "core/event/scan_bodies.h"
#include "core/mapping/live/scan_work.h"

namespace leitstand {
namespace {

/// Returns which of @p points are inside @p crop and not on @p others.
std::vector<std::size_t> pointsInside(const std::vector<Eigen::Vector3f>& points, const MapCrop& crop,
                                      const Pose& scanInMap, std::span<const PlacedBody> others) {
    const std::vector<bool> on = onOthers(points, others, scanInMap);
    std::vector<std::size_t> kept;
    kept.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (points[i].allFinite() && !on[i] && crop.contains(scanInMap * points[i].cast<double>()))
            kept.push_back(i);
    }
    return kept;
}

template <typename T>
void keep(std::vector<T>& list, const std::vector<std::size_t>& kept) {
    if (list.empty()) return;
    for (std::size_t i = 0; i < kept.size(); ++i) list[i] = list[kept[i]];  // kept[i] >= i
    list.resize(kept.size());
}

PointCloud insideCrop(PointCloud cloud, const MapCrop& crop, const Pose& scanInMap,
                      std::span<const PlacedBody> others) {
    const std::vector<std::size_t> kept = pointsInside(cloud.points, crop, scanInMap, others);
    keep(cloud.points, kept);
    keep(cloud.normals, kept);
    keep(cloud.labels, kept);
    return cloud;
}

MatchedCloudPtr insideCrop(const MatchedCloudPtr& whole, const MapCrop& crop, const Pose& scanInMap,
                           const std::vector<PlacedBody>& others, const MatchedClouds& clouds) {
    if (!whole) return nullptr;
    const auto make = [whole, crop, scanInMap, others] {
        return insideCrop(whole->unpacked(), crop, scanInMap, others);
    };
    if (!whole->size()) return clouds.promise(make);
    const PointCloud inside = make();
    if (inside.size() == whole->size()) return whole;
    return clouds.keep(inside, make);
}

}  // namespace

ScanPtr insideCrop(const ScanPtr& scan, const MapCrop& crop, const Pose& scanInMap,
                   std::span<const PlacedBody> others) {
    if (!scan || (crop.open() && others.empty())) return scan;
    const std::vector<std::size_t> kept = pointsInside(scan->points, crop, scanInMap, others);
    if (kept.size() == scan->points.size()) return scan;
    return std::make_shared<const Scan>(selected(*scan, kept));
}

void CroppedScans::setCrop(MapCrop crop) {
    if (crop.polygon == m_crop.polygon && crop.ceiling == m_crop.ceiling) return;
    m_crop = std::move(crop);
    for (auto& [id, fitted] : m_fitted) fitted.stale = true;
}

void CroppedScans::setBodies(std::uint64_t id, std::vector<BodyInScan> bodies) {
    const auto before = m_bodies.find(id);
    if (before == m_bodies.end() ? bodies.empty() : before->second == bodies) return;
    if (bodies.empty()) {
        m_bodies.erase(id);
    } else {
        m_bodies[id] = std::move(bodies);
    }
    if (const auto known = m_fitted.find(id); known != m_fitted.end()) known->second.stale = true;
}

std::vector<BodyInScan> CroppedScans::bodies(std::uint64_t id) const {
    const auto known = m_bodies.find(id);
    return known != m_bodies.end() ? known->second : std::vector<BodyInScan>();
}

void CroppedScans::fit(LiveKeyScan& scan, const MatchedClouds& clouds) {
    const auto known = m_fitted.find(scan.id);
    const auto bodies = m_bodies.find(scan.id);
    const MapCrop everything;
    const MapCrop& crop = scan.part != 0 ? everything : m_crop;
    if (crop.open() && bodies == m_bodies.end()) {
        if (known == m_fitted.end()) return;
        known->second.scan->putAllBack();
        scan.scan = known->second.scan->inside();
        scan.reduced = known->second.wholeReduced;
        m_fitted.erase(known);
        return;
    }
    Fitted& fitted = m_fitted[scan.id];
    if (known == m_fitted.end()) {
        if (!scan.kept) scan.kept = std::make_shared<KeptScan>(scan.scan);
        fitted.scan = scan.kept;
        fitted.wholeReduced = scan.reduced;
    }
    const Pose& here = scan.pose.scanInMap;
    if (fitted.stale || fitted.part != scan.part || fitted.scanInMap.matrix() != here.matrix()) {
        std::vector<PlacedBody> others;
        if (bodies != m_bodies.end()) others = placed(bodies->second, here);
        fitted.stale = false;
        fitted.scanInMap = here;
        fitted.part = scan.part;
        const ScanPtr whole = fitted.scan->whole();
        fitted.scan->leaveOutAllBut(pointsInside(whole->points, crop, here, others), whole);
        fitted.reduced = fitted.scan->leftOut() == 0
                             ? fitted.wholeReduced
                             : insideCrop(fitted.wholeReduced, crop, here, others, clouds);
    }
    scan.scan = fitted.scan->inside();
    scan.reduced = fitted.reduced;
}

}  // namespace leitstand
