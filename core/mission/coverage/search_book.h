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

/// The data from which searched floor is computed: the thinned scans of the map, and the views of cameras.
/// Each view belongs to a scan and moves with it. One thread.
class SearchBook {
public:
    explicit SearchBook(const CoverageSettings& settings = {}) : m_settings(settings) {}

    void add(const ReportScan& scan);
    /// Sets the pose of @p scan and whether it is used (@p counts). Ignores unknown scans.
    void place(std::uint64_t scan, const Pose& scanInMap, bool counts);
    /// Sets the poses of the scans in @p poses. From now on, only scans that are certain in @p poses are
    /// used.
    void follow(std::span<const ScanPose> poses);
    /// Adds @p view. False: it was left out, because its scan has nearly the same view. When there are too
    /// many views, more different views are treated as the same, up to CoverageSettings::coarsest. Beyond
    /// that limit, all further views are left out.
    bool add(const SearchView& view);
    [[nodiscard]] std::size_t views() const { return m_views; }
    /// Returns how many views were left out because there were too many.
    [[nodiscard]] std::size_t leftOut() const { return m_leftOut; }
    [[nodiscard]] std::size_t scans() const { return m_scans.size(); }
    /// Returns all views, by scan.
    [[nodiscard]] std::vector<SearchView> allViews() const;

    /// Computes what was searched until @p until on the storey with @p heights. Only scans and views of that
    /// storey are used. @p trail: where base_link of robots was in the map [m].
    [[nodiscard]] CoverageMapPtr coverage(std::span<const Eigen::Vector3d> trail, Time until = Time::max(),
                                          const StoreyHeights& heights = {}) const;
    /// Computes coverage() for each storey of the map, from the lowest to the highest. There is at least one.
    [[nodiscard]] std::vector<StoreyCoverage> byStorey(std::span<const Eigen::Vector3d> trail,
                                                       Time until = Time::max()) const;

private:
    struct Held {
        ReportScan scan;  ///< the thinned scan
        ShotDensity shots;
        bool counts = true;
    };
    [[nodiscard]] std::vector<ReportScan> counted() const;
    [[nodiscard]] ViewGrain grain(double coarseness) const;
    bool makeRoom(ScanViews& looks);

    CoverageSettings m_settings;
    std::map<std::uint64_t, Held> m_scans;
    std::map<std::uint64_t, ScanViews> m_looks;  ///< by id of the scan, which may not be known yet
    std::size_t m_views = 0, m_leftOut = 0;
    double m_coarseness = 1.0;  ///< least factor for the grain of the settings, for all scans
};

}  // namespace leitstand
