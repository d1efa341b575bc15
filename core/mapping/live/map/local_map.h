#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/base/pose.h"
#include "core/cloud/search/search.h"
#include "core/mapping/live/map/live_map.h"

namespace leitstand {

/// What a scan is registered against: the key scans around it as one cloud. The number of scans is limited,
/// so that the time does not grow with the map.
struct LocalMap {
    std::vector<std::uint64_t> scans;  ///< ids of its scans, nearest first
    PointCloud cloud;                  ///< in the map's frame
    std::unique_ptr<Search> search;    ///< search in `cloud`; null when it is empty
};

/// Settings of localMap().
struct LocalMapSettings {
    int scans = 12;       ///< largest number of scans; the nearest are used
    double voxel = 0.08;  ///< edge of the voxels that thin the cloud [m]
};

/// Returns the distance between two poses [m]. A difference in height is multiplied by four, since the storey
/// below is hidden by the floor.
[[nodiscard]] double mapDistance(const Pose& a, const Pose& b);

/// Returns LiveKeyScan::part of the scan nearest to @p place that is neither uncertain nor set aside; 0 if
/// there is none.
[[nodiscard]] std::uint64_t partAt(std::span<const LiveKeyScan> scans, const Pose& place);
/// Returns those of @p scans that belong to @p part.
[[nodiscard]] std::vector<LiveKeyScan> ofPart(std::span<const LiveKeyScan> scans, std::uint64_t part);

/// Returns the local map around @p place: the nearest of @p scans that are neither uncertain nor set aside.
[[nodiscard]] LocalMap localMap(std::span<const LiveKeyScan> scans, const Pose& place,
                                const LocalMapSettings& settings = {});

}  // namespace leitstand
