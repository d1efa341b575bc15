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

/// Something of a robot's size in another robot's 3D scan: on the floor and apart from everything taller. Its
/// heading is unknown.
struct SeenBody {
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();  ///< of the body, map frame [m]: exact to its width
    double ground = 0.0;                               ///< height of the floor there, map frame [m]
    double top = 0.0;                                  ///< its highest visible point, over the floor [m]
    std::vector<Eigen::Vector2d> points;               ///< its visible points, map frame [m]
    bool fresh = false;                                ///< earlier scans do not have most of its points
};

/// How bodies are distinguished from other things on the floor.
struct SightingSettings {
    double farthest = 6.0;   ///< from the scanner; beyond, a small robot is a handful of points [m]
    double floor = 0.06;     ///< points lower than this over the floor are floor [m]
    double larger = 0.15;    ///< a body may exceed its robot's footprint by so much [m] ...
    double higher = 0.08;    ///< ... and its robot's height by so much [m]
    double lowest = 0.3;     ///< least visible share of its height: a thin mast shows little
    double shortest = 0.35;  ///< least visible share of the footprint's width
    std::size_t leastPoints = 6;
    std::size_t most = 8;  ///< largest number of bodies; the likeliest are returned
};

/// Returns what in @p scan, taken at @p scanInMap, may be a robot with @p body, likeliest first. The robot
/// that took the scan must be removed from it. @p earlier: the map without @p scan; may be empty. @p others:
/// known robots, which are left out.
[[nodiscard]] std::vector<SeenBody> seenBodies(const Scan& scan, const Pose& scanInMap, const RobotBody& body,
                                               const LocalMap& earlier, std::span<const Disc> others = {},
                                               const SightingSettings& settings = {});

/// Returns the share of @p seen's points that lie on or within @p body, grown by @p margin [m], at @p
/// baseInMap.
[[nodiscard]] double shareWithin(const SeenBody& seen, const RobotBody& body, const Pose& baseInMap,
                                 double margin);

}  // namespace leitstand
