#pragma once

#include <vector>

#include "core/base/pose.h"
#include "core/base/time.h"
#include "core/perception/heat/heat.h"
#include "core/perception/pictures/pixel_ray.h"

namespace leitstand {

/// A body's heat, seen from the robot.
struct HeatCue {
    Time at{};
    Ray ray;                    ///< through its middle; in the odometry's frame
    double width = 0.0;         ///< of the blob [rad]
    double temperature = 33.0;  ///< mean [degrees C]
    double confidence = 0.5;    ///< 0 to 1
    double size = 1.0;          ///< square root of the solid angle of what is seen of it [rad]
    bool cut = false;           ///< by the picture's border: there may be more of it
    double clothes = 1.0;       ///< what is lukewarm and hangs together with it [sr]
    bool clothesCut = false;    ///< likewise by the picture's border
};
/// The cues of the bodies in a picture, the most convincing first. @p opticalInOdom: of the camera (x right,
/// y down, z forward) when the picture was taken.
[[nodiscard]] std::vector<HeatCue> cuesFrom(const std::vector<HeatBlob>& blobs, const ThermalPicture& picture,
                                            const CameraInfoSample& camera, const Pose& opticalInOdom,
                                            Time at);
/// Direction of @p cue in base_link, left positive [rad].
[[nodiscard]] double bearingOf(const HeatCue& cue, const Pose& baseInOdom);
/// Where the heat is when that is @p away from the camera, level [m]; in the odometry's frame [m].
[[nodiscard]] Eigen::Vector3d placeOf(const HeatCue& cue, double away);
/// How high the heat is where it meets the vertical through @p place in odom; over the robot's ground [m].
[[nodiscard]] double heightAt(const HeatCue& cue, const Eigen::Vector2d& place, const Pose& baseInOdom);

/// A robot's pose on its ground, without roll, pitch and height.
[[nodiscard]] Eigen::Isometry2d flat(const Pose& baseInOdom);

}  // namespace leitstand
