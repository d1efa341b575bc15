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
    FromHere,  ///< all that a robot scanned, from one scan on
    Robot,     ///< all scans of one robot
    Storey,    ///< all scans on one storey
    Part,      ///< all scans of one part of the map: the first part, or one that is not joined with it
    Scan,      ///< only one scan; its links also move the connected scans after it
};

/// Returns the ids of the key scans of @p map that are moved together with @p scan; all belong to one part of
/// the map. Empty: the scan is missing or set aside, or nothing of the map would be left.
[[nodiscard]] std::set<std::uint64_t> submapOf(const LiveMap& map, std::uint64_t scan, SubmapKind kind);
/// Returns the scans that are not compared with submapOf(). For SubmapKind::Scan, they are what the robot
/// scanned shortly before and after @p scan: they stay when it moves. For all other kinds: none.
[[nodiscard]] std::set<std::uint64_t> leftBehind(const LiveMap& map, std::uint64_t scan, SubmapKind kind);

/// How a submap fits the rest of the map.
struct SubmapFit {
    /// Share of its points that have a point of the rest within SubmapOnMap::Near, 0 to 1.
    double overlap = 0.0;
    double seam = 0.0;  ///< root mean square distance of these pairs [m]
};

/// A submap that the operator drags over the rest of the map. Immutable; any thread.
class SubmapOnMap {
public:
    /// A point overlaps with the rest of the map within this distance [m].
    static constexpr double Near = 0.3;
    static constexpr double LeastOverlap = 0.1;  ///< least SubmapFit::overlap for snapped()

    /// Prepares the scans of @p map that are not set aside: @p submap, and the rest without @p left. Takes
    /// about a second for 1,000 scans. Cancelled: nothing fits.
    SubmapOnMap(LiveMapPtr map, std::set<std::uint64_t> submap, const std::set<std::uint64_t>& left = {},
                const Progress& progress = {});

    [[nodiscard]] const LiveMapPtr& map() const { return m_map; }
    [[nodiscard]] const std::set<std::uint64_t>& submap() const { return m_submap; }
    /// The middle of the submap in the map [m], before it is moved.
    [[nodiscard]] const Eigen::Vector3d& middle() const { return m_middle; }

    /// Returns how the submap fits if it is moved by @p moved. The new pose of a scan in the map is @p moved
    /// times its old pose.
    [[nodiscard]] SubmapFit at(const Pose& moved) const;
    /// Returns the correction near @p moved (as for at()) at which the submap fits the rest best, by GICP
    /// from coarse to fine. Empty: too little of the submap overlaps with the rest, or cancelled.
    [[nodiscard]] std::optional<Pose> snapped(const Pose& moved, const Progress& progress = {}) const;
    /// Returns the poses in the map of the submap's scans after @p moved (as for at()), by id.
    [[nodiscard]] std::map<std::uint64_t, Pose> places(const Pose& moved) const;

private:
    LiveMapPtr m_map;
    std::set<std::uint64_t> m_submap;
    Eigen::Vector3d m_middle = Eigen::Vector3d::Zero();
    PointCloud m_cloud;                ///< part of the submap's points, relative to its middle
    PointCloud m_rest;                 ///< part of the rest's points, in the map
    std::unique_ptr<Search> m_search;  ///< search in m_rest; null: it is empty
};
using SubmapOnMapPtr = std::shared_ptr<const SubmapOnMap>;

}  // namespace leitstand
