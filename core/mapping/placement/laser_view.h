#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/base/time.h"
#include "core/event/cloud_sample.h"
#include "core/mapping/live/map/live_scan.h"
#include "core/mapping/live/scan_cleaning.h"
#include "core/mapping/motion/motion_buffer.h"

namespace leitstand {

/// What stands around a robot as its laser sees it, from one place: its motion and its tilt are taken out.
struct LaserView {
    Time stamp{};                         ///< of the place, robot's clock: the last ray's
    std::vector<Eigen::Vector2f> points;  ///< base_link's place, x ahead and level [m]; floor left out
    Pose tilt = Pose::Identity();         ///< of base_link against that level frame
    double low = 0.1, high = 0.5;  ///< what it sees is between these heights over the robot's ground [m]
};

/// A round place on the map that says nothing of the walls: another robot stands there.
struct Disc {
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();  ///< [m]
    double radius = 0.0;                               ///< [m]
};

/// Leaves out what of @p view, seen from @p baseInMap, lies within @p discs.
void leaveOut(LaserView& view, const Pose& baseInMap, std::span<const Disc> discs);

/// Leaves out what of @p view, seen from @p baseInMap, lies outside @p crop: who stands there is not in the
/// map.
void leaveOutCropped(LaserView& view, const Pose& baseInMap, const MapCrop& crop);

/// @p ranges of a laser at @p laserInBase on a robot that moved as @p motion tells; without motion it counts
/// as at rest and level.
[[nodiscard]] LaserView laserView(const RangesSample& ranges, const Pose& laserInBase,
                                  const MotionBuffer& motion);

/// The same of a 3D scan: what stands up within the robot's reach of heights.
[[nodiscard]] LaserView laserView(const LiveScan& scan);

}  // namespace leitstand
