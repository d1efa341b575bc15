#include "core/mission/coverage/search_book.h"

#include <algorithm>

#include "core/cloud/filters/voxel_grid.h"
#include "core/event/scan_pose.h"

namespace leitstand {
namespace {

/// Keeps one point per cube. Floor is kept apart from what stands on it.
ScanPtr thinned(const Scan& scan, const CoverageSettings& settings) {
    PointCloud cloud;
    const auto reach = static_cast<float>(settings.scanReach);
    for (std::size_t i = 0; i < scan.points.size(); ++i) {
        if (!scan.points[i].allFinite() || scan.points[i].norm() > reach) continue;
        cloud.points.push_back(scan.points[i]);
        cloud.labels.push_back(i < scan.labels.size() ? scan.labels[i] : Label::Unlabelled);
    }
    cloud = voxelGrid(cloud, settings.scanCell);
    auto kept = std::make_shared<Scan>();
    kept->robot = scan.robot;
    kept->points = std::move(cloud.points);
    kept->labels = std::move(cloud.labels);
    return kept;
}

}  // namespace

void SearchBook::add(const ReportScan& scan) {
    if (!scan.scan) return;
    Held held;
    held.shots = ShotDensity::of(*scan.scan);
    held.scan = scan;
    held.scan.scan = thinned(*scan.scan, m_settings);
    m_scans.insert_or_assign(scan.id, std::move(held));
}

void SearchBook::place(std::uint64_t scan, const Pose& scanInMap, bool counts) {
    const auto found = m_scans.find(scan);
    if (found == m_scans.end()) return;
    found->second.scan.scanInMap = scanInMap;
    found->second.counts = counts;
}

void SearchBook::follow(std::span<const ScanPose> poses) {
    for (auto& [id, held] : m_scans) held.counts = false;
    for (const ScanPose& pose : poses) place(pose.scan, pose.scanInMap, pose.trust == ScanTrust::Certain);
}

ViewGrain SearchBook::grain(double coarseness) const {
    return {coarseness * m_settings.viewApart, coarseness * m_settings.viewTurned};
}

/// Coarsens the grain of @p looks, or of all scans, by one step. False when it is the coarsest already.
bool SearchBook::makeRoom(ScanViews& looks) {
    constexpr double Step = 1.25;
    const auto thin = [this](ScanViews& some, double coarseness) {
        m_views -= some.size();
        some.thin(grain(coarseness));
        m_views += some.size();
    };
    if (looks.size() >= m_settings.mostViewsOfScan) {
        const double now = looks.grain().apart / m_settings.viewApart;
        if (now >= m_settings.coarsest) return false;
        thin(looks, std::min(m_settings.coarsest, Step * now));
        return true;
    }
    if (m_coarseness >= m_settings.coarsest) return false;
    m_coarseness = std::min(m_settings.coarsest, Step * m_coarseness);
    for (auto& [scan, some] : m_looks) thin(some, m_coarseness);
    return true;
}

bool SearchBook::add(const SearchView& view) {
    if (!view.cameraInScan.matrix().allFinite()) return false;
    ScanViews& looks = m_looks.try_emplace(view.scan, grain(m_coarseness)).first->second;
    while (!looks.holds(view)) {
        if (m_views < m_settings.mostViews && looks.size() < m_settings.mostViewsOfScan) {
            looks.add(view);
            ++m_views;
            return true;
        }
        if (!makeRoom(looks)) {
            ++m_leftOut;
            return false;
        }
    }
    return false;
}

std::vector<SearchView> SearchBook::allViews() const {
    std::vector<SearchView> all;
    all.reserve(m_views);
    for (const auto& [scan, looks] : m_looks)
        all.insert(all.end(), looks.views().begin(), looks.views().end());
    return all;
}

std::vector<ReportScan> SearchBook::counted() const {
    std::vector<ReportScan> scans;
    for (const auto& [id, held] : m_scans) {
        if (held.counts) scans.push_back(held.scan);
    }
    return scans;
}

CoverageMapPtr SearchBook::coverage(std::span<const Eigen::Vector3d> trail, Time until,
                                    const StoreyHeights& heights) const {
    auto map =
        std::make_shared<CoverageMap>(SearchGround::of(counted(), trail, m_settings, heights), m_settings);
    for (const auto& [id, held] : m_scans) {
        // The ceiling between two storeys is unknown, so looks from another storey do not count.
        if (!held.counts || !heights.hold(held.scan.baseInMap().translation().z())) continue;
        map->scan(held.shots, held.scan.scanInMap);
        const auto looks = m_looks.find(id);
        if (looks == m_looks.end()) continue;
        for (const SearchView& view : looks->second.views()) {
            if (view.seen <= until) map->look(view, held.scan.scanInMap);
        }
    }
    return map;
}

std::vector<StoreyCoverage> SearchBook::byStorey(std::span<const Eigen::Vector3d> trail, Time until) const {
    std::vector<StoreyCoverage> storeys;
    for (const StoreyShare& share : sharesOf(storeysOf(counted())))
        storeys.push_back({share, coverage(trail, until, share.heights)});
    return storeys;
}

}  // namespace leitstand
