#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "core/event/scan_pose.h"
#include "core/mapping/report_scan.h"
#include "core/mission/coverage/coverage_map.h"
#include "core/mission/coverage/scan_views.h"

namespace leitstand {

/// Holds what shows which floor was searched: the thinned scans of the map, and the views of cameras. Each
/// view hangs on a scan and moves with it. One thread.
class SearchBook {
public:
    explicit SearchBook(const CoverageSettings& settings = {}) : m_settings(settings) {}

    void add(const ReportScan& scan);
    /// Sets the pose of @p scan and whether it counts. Ignores an unknown scan.
    void place(std::uint64_t scan, const Pose& scanInMap, bool counts);
    /// Sets the poses of the scans in @p poses. Only scans that @p poses holds as certain count from now on.
    void follow(std::span<const ScanPose> poses);
    /// Adds @p view; false: it was left out, because nearly the same view of its scan is known. When there
    /// are too many views, views that differ more count as the same, up to CoverageSettings::coarsest. Beyond
    /// that, all further views are left out.
    bool add(const SearchView& view);
    [[nodiscard]] std::size_t views() const { return m_views; }
    /// Returns how many views were left out because there were too many.
    [[nodiscard]] std::size_t leftOut() const { return m_leftOut; }
    [[nodiscard]] std::size_t scans() const { return m_scans.size(); }
    /// Returns all views, by scan.
    [[nodiscard]] std::vector<SearchView> allViews() const;

    /// Computes what was searched by the time @p until on the storey with @p heights. Only scans and views
    /// from that storey count. @p trail: base_link where robots were, in the map [m].
    [[nodiscard]] CoverageMapPtr coverage(std::span<const Eigen::Vector3d> trail, Time until = Time::max(),
                                          const StoreyHeights& heights = {}) const;
    /// Computes coverage() for each storey of the map, from the lowest on; at least one.
    [[nodiscard]] std::vector<StoreyCoverage> byStorey(std::span<const Eigen::Vector3d> trail,
                                                       Time until = Time::max()) const;

private:
    struct Held {
        ReportScan scan;  ///< thinned
        ShotDensity shots;
        bool counts = true;
    };
    [[nodiscard]] std::vector<ReportScan> counted() const;
    [[nodiscard]] ViewGrain grain(double coarseness) const;
    bool makeRoom(ScanViews& looks);

    CoverageSettings m_settings;
    std::map<std::uint64_t, Held> m_scans;
    std::map<std::uint64_t, ScanViews> m_looks;  ///< by scan, which may not be known yet
    std::size_t m_views = 0, m_leftOut = 0;
    double m_coarseness = 1.0;  ///< least factor on the settings' grain, for all scans
};

}  // namespace leitstand
