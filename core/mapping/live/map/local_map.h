#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/base/pose.h"
#include "core/cloud/search/search.h"
#include "core/mapping/live/map/live_map.h"

namespace leitstand {

/// What a scan is registered against: the key scans around it as one cloud. Their number is bounded, so that
/// the time does not grow with the map.
struct LocalMap {
    std::vector<std::uint64_t> scans;  ///< ids, nearest first
    PointCloud cloud;                  ///< in the map's frame
    std::unique_ptr<Search> search;    ///< over the cloud; null when it is empty
};

/// Settings of localMap().
struct LocalMapSettings {
    int scans = 12;       ///< largest number of scans; the nearest of those that count
    double voxel = 0.08;  ///< edge of the voxels that thin the cloud [m]
};

/// Returns the distance between two poses [m]. Their difference in height counts four times, since nobody
/// sees the storey below through a floor.
[[nodiscard]] double mapDistance(const Pose& a, const Pose& b);

/// Returns LiveKeyScan::part of the scan nearest to @p place, among those that count. Also 0 if there is
/// none.
[[nodiscard]] std::uint64_t partAt(std::span<const LiveKeyScan> scans, const Pose& place);
/// Returns those of @p scans that are of @p part.
[[nodiscard]] std::vector<LiveKeyScan> ofPart(std::span<const LiveKeyScan> scans, std::uint64_t part);

/// Returns the local map of those of @p scans that count and are nearest to @p place.
[[nodiscard]] LocalMap localMap(std::span<const LiveKeyScan> scans, const Pose& place,
                                const LocalMapSettings& settings = {});

}  // namespace leitstand
