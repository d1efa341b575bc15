#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/cloud/scan.h"
#include "core/mapping/live/map/local_map.h"
#include "core/mapping/live/scan_cleaning.h"
#include "core/mapping/placement/laser_view.h"

namespace leitstand {

/// Something of a robot's size in another robot's 3D scan. It is on the floor and apart from everything
/// taller. Its heading is unknown.
struct SeenBody {
    /// Middle in the map [m]; its error is up to the body's width.
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    double ground = 0.0;                  ///< height of the floor there, in the map [m]
    double top = 0.0;                     ///< height of its highest visible point above the floor [m]
    std::vector<Eigen::Vector2d> points;  ///< its visible points in the map, seen from above [m]
    bool fresh = false;                   ///< most of its points are not in earlier scans
};

/// How bodies are distinguished from other things on the floor.
struct SightingSettings {
    /// Largest distance from the scanner [m]; farther away a small robot has only a few points.
    double farthest = 6.0;
    double floor = 0.06;     ///< points lower than this above the floor belong to the floor [m]
    double larger = 0.15;    ///< a body may be larger than its robot's footprint by this [m] ...
    double higher = 0.08;    ///< ... and higher than its robot by this [m]
    double lowest = 0.3;     ///< least share of its height that is visible: little is seen of a thin mast
    double shortest = 0.35;  ///< least share of its footprint's width that is visible
    std::size_t leastPoints = 6;
    std::size_t most = 8;  ///< largest number of bodies; the most likely ones are returned
};

/// Returns what may be a robot of the shape @p body in @p scan, taken at @p scanInMap. The most likely comes
/// first. The robot that took the scan must have been removed from it. @p earlier: the map without @p scan;
/// may be empty. @p others: known robots, which are left out.
[[nodiscard]] std::vector<SeenBody> seenBodies(const Scan& scan, const Pose& scanInMap, const RobotBody& body,
                                               const LocalMap& earlier, std::span<const Disc> others = {},
                                               const SightingSettings& settings = {});

/// Returns the share of points of @p seen that lie on or within @p body at @p baseInMap, grown by @p margin
/// [m].
[[nodiscard]] double shareWithin(const SeenBody& seen, const RobotBody& body, const Pose& baseInMap,
                                 double margin);

}  // namespace leitstand
