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
    Time stamp{};                         ///< of that place: when the last ray was shot, robot's clock
    std::vector<Eigen::Vector2f> points;  ///< from base_link, level, x ahead [m]; without the floor
    Pose tilt = Pose::Identity();         ///< of base_link against that level frame
    double low = 0.1, high = 0.5;         ///< heights over the robot's ground of what the laser sees [m]
};

/// A round place on the map that holds no information on walls: another robot stands there.
struct Disc {
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();  ///< [m]
    double radius = 0.0;                               ///< [m]
};

/// Removes points of @p view, seen from @p baseInMap, that lie within @p discs.
void leaveOut(LaserView& view, const Pose& baseInMap, std::span<const Disc> discs);

/// Removes points of @p view, seen from @p baseInMap, that lie outside @p crop, since the map lacks what
/// stands there.
void leaveOutCropped(LaserView& view, const Pose& baseInMap, const MapCrop& crop);

/// Returns the view of @p ranges from a laser at @p laserInBase. Takes out the motion that @p motion holds;
/// without it the robot counts as at rest and level.
[[nodiscard]] LaserView laserView(const RangesSample& ranges, const Pose& laserInBase,
                                  const MotionBuffer& motion);

/// Returns the view of a 3D scan: its points at heights from LaserView::low to LaserView::high.
[[nodiscard]] LaserView laserView(const LiveScan& scan);

}  // namespace leitstand
