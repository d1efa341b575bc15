#pragma once

#include <optional>

#include "core/perception/surroundings/virtual_scan.h"
#include "robots/control/driving/heat_cue.h"

namespace leitstand {

struct HeatTargetSettings {
    double bandMargin = 0.05;  ///< points so far beside the heat count as the victim's [rad]
    double lying = 0.55;       ///< higher points are no part of a lying victim [m]
    double hanging = 0.25;     ///< obstacles that begin higher, as a shelf, are no part of a victim [m]
    double length = 1.2;       ///< farthest that parts of a victim are from its heat [m]
    double link = 0.25;        ///< largest gap between points of one victim [m]
};

/// The surface point of a victim that is nearest to the robot's front.
struct HeatTarget {
    Eigen::Vector2d inBase = Eigen::Vector2d::Zero();  ///< [m]
    double distance = 0.0;                             ///< from the body's front [m]
    double age = 0.0;                                  ///< of the measurement [s]
    double top = 0.0;                                  ///< height of what stands there [m]
    bool certain = false;                              ///< the heat is on this surface, not behind its edge
    double heat = 0.0;  ///< level distance from the camera to the victim's warm part [m]
};

/// Looks for the surface in @p view that @p cue is on, and for all of the victim that is connected to it.
/// Returns the point nearest to the front of @p body, which is in base_link. Empty: there is no surface.
[[nodiscard]] std::optional<HeatTarget> heatTarget(const HeatCue& cue, const VirtualScanView& view,
                                                   const Pose& baseInOdom, const BodyBox& body,
                                                   const HeatTargetSettings& settings = {});

}  // namespace leitstand
