#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/base/time.h"
#include "core/mapping/live/map/live_scan.h"
#include "core/mapping/live/scan_cleaning.h"
#include "core/mapping/motion/motion_buffer.h"

namespace leitstand {

struct RangesSample;

/// The surroundings of a robot as its laser sees them from one place; its motion and its tilt are taken out.
struct LaserView {
    Time stamp{};                         ///< of that place, robot's clock: the last ray's
    std::vector<Eigen::Vector2f> points;  ///< from base_link's place, x ahead and level [m]; floor left out
    Pose tilt = Pose::Identity();         ///< of base_link against that level frame
    double low = 0.1, high = 0.5;         ///< heights of what it sees over the robot's ground [m]
};

/// A round place on the map that holds no information on walls: another robot stands there.
struct Disc {
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();  ///< [m]
    double radius = 0.0;                               ///< [m]
};

/// Removes points of @p view, seen from @p baseInMap, that lie within @p discs.
void leaveOut(LaserView& view, const Pose& baseInMap, std::span<const Disc> discs);

/// Removes points of @p view, seen from @p baseInMap, that lie outside @p crop: what stands there is not in
/// the map.
void leaveOutCropped(LaserView& view, const Pose& baseInMap, const MapCrop& crop);

/// Returns the view of @p ranges from a laser at @p laserInBase, on a robot that moved as @p motion holds.
/// Without motion it counts as at rest and level.
[[nodiscard]] LaserView laserView(const RangesSample& ranges, const Pose& laserInBase,
                                  const MotionBuffer& motion);

/// Returns the view of a 3D scan: what stands upright within the robot's reach of heights.
[[nodiscard]] LaserView laserView(const LiveScan& scan);

}  // namespace leitstand
