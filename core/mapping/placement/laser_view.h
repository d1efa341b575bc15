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

/// The surroundings of a robot as its laser sees them from one place. The robot's motion and tilt are
/// removed.
struct LaserView {
    Time stamp{};  ///< when the last ray was shot, robot's clock; the view is from that place
    std::vector<Eigen::Vector2f> points;  ///< in a level frame at base_link, x ahead, without the floor [m]
    Pose tilt = Pose::Identity();         ///< pose of base_link in that level frame
    double low = 0.1, high = 0.5;  ///< range of heights above the robot's ground that the laser sees [m]
};

/// A round place on the map without information about walls, because another robot stands there.
struct Disc {
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();  ///< middle in the map [m]
    double radius = 0.0;                               ///< [m]
};

/// Removes points of @p view, seen from @p baseInMap, that lie within @p discs.
void leaveOut(LaserView& view, const Pose& baseInMap, std::span<const Disc> discs);

/// Removes points of @p view, seen from @p baseInMap, that lie outside @p crop. The map does not show what is
/// there.
void leaveOutCropped(LaserView& view, const Pose& baseInMap, const MapCrop& crop);

/// Returns the view of @p ranges from a laser at @p laserInBase. Removes the robot's motion, which @p motion
/// knows. Where it is unknown, the robot is assumed to be level and at rest.
[[nodiscard]] LaserView laserView(const RangesSample& ranges, const Pose& laserInBase,
                                  const MotionBuffer& motion);

/// Returns the view of a 3D scan: its points at heights from LaserView::low to LaserView::high.
[[nodiscard]] LaserView laserView(const LiveScan& scan);

}  // namespace leitstand
