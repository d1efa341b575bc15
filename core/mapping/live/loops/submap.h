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
    Robot,     ///< all that it scanned
    Storey,    ///< all on one storey
    Part,      ///< a part of the map that has not met the first one, or the first one
    Scan,      ///< one scan alone: what hangs together with it follows by its links
};

/// The key scans of @p map that are moved with @p scan, by id; all of one part of the
/// map. Empty: the map has no such scan that counts, or nothing of the map would be left.
[[nodiscard]] std::set<std::uint64_t> submapOf(const LiveMap& map, std::uint64_t scan, SubmapKind kind);
/// What these are not compared with: of one scan alone what its robot scanned shortly before and after it,
/// which it leaves behind.
[[nodiscard]] std::set<std::uint64_t> leftBehind(const LiveMap& map, std::uint64_t scan, SubmapKind kind);

/// How a submap lies on the rest of the map.
struct SubmapFit {
    double overlap = 0.0;  ///< share of its points with a point of the rest within SubmapOnMap::Near, 0 to 1
    double seam = 0.0;     ///< root mean square of how far these two are apart [m]
};

/// A submap that is dragged over the rest of the map. Immutable; any thread.
class SubmapOnMap {
public:
    static constexpr double Near = 0.3;          ///< [m]
    static constexpr double LeastOverlap = 0.1;  ///< to be snapped

    /// Of those scans of @p map that count, @p submap, and the rest without @p left. Takes about a second for
    /// 1,000 scans; cancelled, it fits nothing.
    SubmapOnMap(LiveMapPtr map, std::set<std::uint64_t> submap, const std::set<std::uint64_t>& left = {},
                const Progress& progress = {});

    [[nodiscard]] const LiveMapPtr& map() const { return m_map; }
    [[nodiscard]] const std::set<std::uint64_t>& submap() const { return m_submap; }
    /// The middle of the submap in the map [m].
    [[nodiscard]] const Eigen::Vector3d& middle() const { return m_middle; }

    /// @p moved: to put before the poses of the submap's scans, in the map.
    [[nodiscard]] SubmapFit at(const Pose& moved) const;
    /// The pose near @p moved at which it lies best on the rest, by GICP from coarse to fine; empty: too
    /// little of it lies on anything there.
    [[nodiscard]] std::optional<Pose> snapped(const Pose& moved, const Progress& progress = {}) const;
    /// Where the submap's scans are then.
    [[nodiscard]] std::map<std::uint64_t, Pose> places(const Pose& moved) const;

private:
    LiveMapPtr m_map;
    std::set<std::uint64_t> m_submap;
    Eigen::Vector3d m_middle = Eigen::Vector3d::Zero();
    PointCloud m_cloud;                ///< some points of the submap, about its middle
    PointCloud m_rest;                 ///< likewise, of the rest, in the map
    std::unique_ptr<Search> m_search;  ///< over the rest; null: it is empty
};
using SubmapOnMapPtr = std::shared_ptr<const SubmapOnMap>;

}  // namespace leitstand
