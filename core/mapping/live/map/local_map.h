#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/base/pose.h"
#include "core/cloud/search/search.h"
#include "core/mapping/live/map/live_map.h"

namespace leitstand {

/// What a scan is registered against: the key scans about it as one cloud, their number bounded, so that the
/// time does not grow with the map.
struct LocalMap {
    std::vector<std::uint64_t> scans;  ///< ids, nearest first
    PointCloud cloud;                  ///< in the map's frame
    std::unique_ptr<Search> search;    ///< over the cloud; null when it is empty
};

/// How much of the map is taken.
struct LocalMapSettings {
    int scans = 12;       ///< the nearest, of those that count
    double voxel = 0.08;  ///< the cloud is thinned to this [m]
};

/// How far two poses are from each other for the map: heights count four times, since nobody sees through a
/// floor what is a storey below [m].
[[nodiscard]] double mapDistance(const Pose& a, const Pose& b);

/// LiveKeyScan::part of the scan that counts nearest to @p place; 0: there is none.
[[nodiscard]] std::uint64_t partAt(std::span<const LiveKeyScan> scans, const Pose& place);
/// Those of @p scans that are of @p part.
[[nodiscard]] std::vector<LiveKeyScan> ofPart(std::span<const LiveKeyScan> scans, std::uint64_t part);

/// The local map about @p place.
[[nodiscard]] LocalMap localMap(std::span<const LiveKeyScan> scans, const Pose& place,
                                const LocalMapSettings& settings = {});

}  // namespace leitstand
