#pragma once

#include <optional>

#include "core/perception/surroundings/virtual_scan.h"
#include "robots/control/driving/heat_cue.h"

namespace leitstand {

struct HeatTargetSettings {
    double bandMargin = 0.05;  ///< points at most this far beside the heat belong to the victim [rad]
    double lying = 0.55;       ///< points above this do not belong to a lying victim [m]
    /// Obstacles that begin above this, such as a shelf, do not belong to a victim [m].
    double hanging = 0.25;
    double length = 1.2;  ///< parts of a victim are at most this far from its heat [m]
    double link = 0.25;   ///< largest gap between points of one victim [m]
};

/// The point on a victim's surface that is nearest to the robot's front.
struct HeatTarget {
    Eigen::Vector2d inBase = Eigen::Vector2d::Zero();  ///< position in base_link [m]
    double distance = 0.0;                             ///< distance from the body's front [m]
    double age = 0.0;                                  ///< age of the measurement [s]
    double top = 0.0;                                  ///< height of the thing there [m]
    bool certain = false;  ///< whether the heat is on this surface; otherwise it may be behind its edge
    double heat = 0.0;     ///< horizontal distance from the camera to the victim's warm part [m]
};

/// Looks in @p view for the surface on which @p cue is, and for everything connected to it that may belong to
/// the victim. Returns the point nearest to the front of @p body, which is in base_link. Empty: there is no
/// surface.
[[nodiscard]] std::optional<HeatTarget> heatTarget(const HeatCue& cue, const VirtualScanView& view,
                                                   const Pose& baseInOdom, const BodyBox& body,
                                                   const HeatTargetSettings& settings = {});

}  // namespace leitstand
