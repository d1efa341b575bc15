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

/// Something of a robot's size that another robot's 3D scan shows: on the floor and apart from all that is
/// taller. Which way it looks nobody knows.
struct SeenBody {
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();  ///< of the body, map frame [m]: give or take its width
    double ground = 0.0;                               ///< height of the floor there, map frame [m]
    double top = 0.0;                                  ///< the highest that is seen of it, over the floor [m]
    std::vector<Eigen::Vector2d> points;               ///< that it is seen by, map frame [m]
    bool fresh = false;                                ///< earlier scans do not have it
};

/// How bodies are told from what else stands on the floor.
struct SightingSettings {
    double farthest = 6.0;   ///< of the scanner: beyond, a small robot is a handful of points [m]
    double floor = 0.06;     ///< what is lower over the floor is floor [m]
    double larger = 0.15;    ///< a body may be so much longer and wider than its robot's footprint [m] ...
    double higher = 0.08;    ///< ... and so much higher [m]
    double lowest = 0.3;     ///< share of its height that is seen at least: of a thin mast there is little
    double shortest = 0.35;  ///< share of the footprint's width that is seen at least
    std::size_t leastPoints = 6;
    std::size_t most = 8;  ///< the likeliest
};

/// What in @p scan (cleaned of its own robot, at @p scanInMap) may be a robot that takes up @p body,
/// likeliest first; @p earlier: the map without this scan, which may be empty; @p others: robots known to be
/// there.
[[nodiscard]] std::vector<SeenBody> seenBodies(const Scan& scan, const Pose& scanInMap, const RobotBody& body,
                                               const LocalMap& earlier, std::span<const Disc> others = {},
                                               const SightingSettings& settings = {});

/// Share of @p seen's points that lie on or within @p body, grown by @p margin [m], at @p baseInMap.
[[nodiscard]] double shareWithin(const SeenBody& seen, const RobotBody& body, const Pose& baseInMap,
                                 double margin);

}  // namespace leitstand
