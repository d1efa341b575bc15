#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "core/event/map_samples.h"
#include "core/mapping/report_scan.h"
#include "core/mission/coverage/coverage_map.h"
#include "core/mission/coverage/scan_views.h"

namespace leitstand {

/// Everything that tells what was searched: the scans of the map, thinned, and where cameras looked from.
/// All of it hangs on scans, so that what was searched moves with them. One thread.
class SearchBook {
public:
    explicit SearchBook(const CoverageSettings& settings = {}) : m_settings(settings) {}

    void add(const ReportScan& scan);
    /// Where a scan is now, and whether it counts; what is not known is passed by.
    void place(std::uint64_t scan, const Pose& scanInMap, bool counts);
    /// Where the scans are now; those that are not named do not count.
    void follow(std::span<const ScanPose> poses);
    /// False when nearly the same view of that scan is known. Where there are many, views that differ more
    /// are one too, up to CoverageSettings::coarsest; beyond that new ones are left out.
    bool add(const SearchView& view);
    [[nodiscard]] std::size_t views() const { return m_views; }
    /// How many times a view was left out that would have told something.
    [[nodiscard]] std::size_t leftOut() const { return m_leftOut; }
    [[nodiscard]] std::size_t scans() const { return m_scans.size(); }
    /// All views, by scan.
    [[nodiscard]] std::vector<SearchView> allViews() const;

    /// What was searched @p until then of the storey with @p heights, from what looked at it from there.
    /// @p trail: base_link where robots were, in the map [m].
    [[nodiscard]] CoverageMapPtr coverage(std::span<const Eigen::Vector3d> trail, Time until = Time::max(),
                                          const StoreyHeights& heights = {}) const;
    /// Likewise, of each storey of the map, from the lowest on; at least one.
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
    double m_coarseness = 1.0;  ///< of all scans, at least; times the settings' grain
};

}  // namespace leitstand
