#include "core/mapping/live/cropped_scans.h"

#include <utility>
#include <vector>

#include "core/mapping/live/scan_work.h"

namespace leitstand {
namespace {

/// Which of @p points are inside @p crop.
std::vector<std::size_t> pointsInside(const std::vector<Eigen::Vector3f>& points, const MapCrop& crop,
                                      const Pose& scanInMap) {
    std::vector<std::size_t> kept;
    kept.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (points[i].allFinite() && crop.contains(scanInMap * points[i].cast<double>())) kept.push_back(i);
    }
    return kept;
}

template <typename T>
void keep(std::vector<T>& list, const std::vector<std::size_t>& kept) {
    if (list.empty()) return;
    for (std::size_t i = 0; i < kept.size(); ++i) list[i] = list[kept[i]];  // kept[i] >= i
    list.resize(kept.size());
}

std::shared_ptr<const PackedCloud> insideCrop(const std::shared_ptr<const PackedCloud>& packed,
                                              const MapCrop& crop, const Pose& scanInMap) {
    if (!packed) return nullptr;
    PointCloud cloud = packed->unpacked();
    const std::vector<std::size_t> kept = pointsInside(cloud.points, crop, scanInMap);
    if (kept.size() == cloud.points.size()) return packed;
    keep(cloud.points, kept);
    keep(cloud.normals, kept);
    keep(cloud.labels, kept);
    return std::make_shared<const PackedCloud>(cloud);
}

}  // namespace

ScanPtr insideCrop(const ScanPtr& scan, const MapCrop& crop, const Pose& scanInMap) {
    if (!scan || crop.open()) return scan;
    const std::vector<std::size_t> kept = pointsInside(scan->points, crop, scanInMap);
    if (kept.size() == scan->points.size()) return scan;
    return std::make_shared<const Scan>(selected(*scan, kept));
}

void CroppedScans::setCrop(MapCrop crop) {
    if (crop.polygon == m_crop.polygon && crop.ceiling == m_crop.ceiling) return;
    m_crop = std::move(crop);
    for (auto& [id, fitted] : m_fitted) fitted.scan.reset();
}

void CroppedScans::fit(LiveKeyScan& scan) {
    const auto known = m_fitted.find(scan.id);
    if (m_crop.open()) {
        if (known == m_fitted.end()) return;
        scan.scan = known->second.whole;
        scan.reduced = known->second.wholeReduced;
        m_fitted.erase(known);
        return;
    }
    Fitted& fitted = known != m_fitted.end()
                         ? known->second
                         : m_fitted.emplace(scan.id, Fitted{scan.scan, scan.reduced, {}, {}}).first->second;
    const Pose& here = scan.pose.scanInMap;
    if (!fitted.scan || fitted.scanInMap.matrix() != here.matrix()) {
        fitted.scanInMap = here;
        fitted.scan = insideCrop(fitted.whole, m_crop, here);
        fitted.reduced =
            fitted.scan == fitted.whole ? fitted.wholeReduced : insideCrop(fitted.wholeReduced, m_crop, here);
    }
    scan.scan = fitted.scan;
    scan.reduced = fitted.reduced;
}

}  // namespace leitstand
