#pragma once

#include <optional>

#include "core/perception/surroundings/virtual_scan.h"
#include "robots/control/driving/heat_cue.h"

namespace leitstand {

struct HeatTargetSettings {
    double bandMargin = 0.05;  ///< points so far beside the heat count as the victim's [rad]
    double lying = 0.55;       ///< higher points are no part of a lying victim [m]
    double hanging = 0.25;     ///< nor are obstacles that begin higher over the floor, as a shelf [m]
    double length = 1.2;       ///< of a victim, from its heat [m]
    double link = 0.25;        ///< largest gap between points of one victim [m]
};

/// The surface point of a victim that is nearest to the robot's front.
struct HeatTarget {
    Eigen::Vector2d inBase = Eigen::Vector2d::Zero();  ///< [m]
    double distance = 0.0;                             ///< from the body's front [m]
    double age = 0.0;                                  ///< of the measurement [s]
    double top = 0.0;                                  ///< height of what stands there [m]
    bool certain = false;                              ///< the heat does not pass beside its edge
    double heat = 0.0;  ///< level distance from the camera to its warm part [m]
};

/// Returns the surface in @p view that @p cue is on, with all of the victim that is connected to it. Empty
/// when there is no surface. @p body: of the robot, in base_link.
[[nodiscard]] std::optional<HeatTarget> heatTarget(const HeatCue& cue, const VirtualScanView& view,
                                                   const Pose& baseInOdom, const BodyBox& body,
                                                   const HeatTargetSettings& settings = {});

}  // namespace leitstand
