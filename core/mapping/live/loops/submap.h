#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "core/base/pose.h"
#include "core/base/progress.h"
#include "core/cloud/search/search.h"
#include "core/mapping/live/map/live_map.h"

namespace leitstand {

/// Which key scans an operator moves together.
enum class SubmapKind : std::uint8_t {
    FromHere,  ///< what a robot scanned from one scan on
    Robot,     ///< all scans of one robot
    Storey,    ///< all scans on one storey
    Part,      ///< all scans of one part of the map: the first one, or one that has not met it
    Scan,      ///< one scan alone; its links move connected scans after it
};

/// Returns the key scans of @p map that are moved with @p scan, by id; all are of one part of the map. Empty:
/// the map has no such scan that counts, or nothing of the map would be left.
[[nodiscard]] std::set<std::uint64_t> submapOf(const LiveMap& map, std::uint64_t scan, SubmapKind kind);
/// Returns the scans that submapOf() is not compared with. For SubmapKind::Scan, they are what the robot
/// scanned shortly before and after @p scan, which leaves them behind. For all other kinds: none.
[[nodiscard]] std::set<std::uint64_t> leftBehind(const LiveMap& map, std::uint64_t scan, SubmapKind kind);

/// How a submap fits the rest of the map.
struct SubmapFit {
    double overlap = 0.0;  ///< share of its points with a point of the rest within SubmapOnMap::Near, 0 to 1
    double seam = 0.0;     ///< root mean square of the distances of these pairs [m]
};

/// A submap that is dragged over the rest of the map. Immutable; any thread.
class SubmapOnMap {
public:
    static constexpr double Near = 0.3;  ///< largest distance of a point from the rest, for both to meet [m]
    static constexpr double LeastOverlap = 0.1;  ///< least SubmapFit::overlap for snapped()

    /// Prepares the scans of @p map that count: those of @p submap, and the rest without @p left. Takes about
    /// a second for 1,000 scans. Cancelled: nothing fits.
    SubmapOnMap(LiveMapPtr map, std::set<std::uint64_t> submap, const std::set<std::uint64_t>& left = {},
                const Progress& progress = {});

    [[nodiscard]] const LiveMapPtr& map() const { return m_map; }
    [[nodiscard]] const std::set<std::uint64_t>& submap() const { return m_submap; }
    /// The middle of the submap in the map [m].
    [[nodiscard]] const Eigen::Vector3d& middle() const { return m_middle; }

    /// Returns the fit when @p moved is put before the poses of the submap's scans in the map.
    [[nodiscard]] SubmapFit at(const Pose& moved) const;
    /// Returns the correction near @p moved (as in at()) at which the submap fits the rest best, by GICP from
    /// coarse to fine. Empty: too little of the submap lies on anything there, or cancelled.
    [[nodiscard]] std::optional<Pose> snapped(const Pose& moved, const Progress& progress = {}) const;
    /// Returns the poses of the submap's scans in the map after @p moved (as in at()), by id.
    [[nodiscard]] std::map<std::uint64_t, Pose> places(const Pose& moved) const;

private:
    LiveMapPtr m_map;
    std::set<std::uint64_t> m_submap;
    Eigen::Vector3d m_middle = Eigen::Vector3d::Zero();
    PointCloud m_cloud;                ///< some points of the submap, relative to its middle
    PointCloud m_rest;                 ///< some points of the rest, in the map
    std::unique_ptr<Search> m_search;  ///< over the rest; null: it is empty
};
using SubmapOnMapPtr = std::shared_ptr<const SubmapOnMap>;

}  // namespace leitstand
