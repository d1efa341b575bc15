#pragma once

#include <vector>

#include "core/base/pose.h"
#include "core/base/time.h"
#include "core/perception/heat/heat.h"
#include "core/perception/pictures/pixel_ray.h"

namespace leitstand {

struct CameraInfoSample;

/// Heat of a body, as seen from the robot.
struct HeatCue {
    Time at{};
    Ray ray;                    ///< ray through its middle, in the odometry's frame
    double width = 0.0;         ///< width of the blob [rad]
    double temperature = 33.0;  ///< mean temperature [degrees C]
    double confidence = 0.5;    ///< 0 to 1
    double size = 1.0;          ///< square root of the visible solid angle [rad]
    bool cut = false;           ///< whether the picture's border cuts it: the body may be larger
    double clothes = 1.0;       ///< lukewarm area connected to the warm one [sr]
    bool clothesCut = false;    ///< whether the picture's border cuts the lukewarm area
};
/// Returns a cue for each of @p blobs that is a body, in their order: the most convincing comes first.
/// @p opticalInOdom: pose of the camera (x right, y down, z forward) when the picture was taken.
[[nodiscard]] std::vector<HeatCue> cuesFrom(const std::vector<HeatBlob>& blobs, const ThermalPicture& picture,
                                            const CameraInfoSample& camera, const Pose& opticalInOdom,
                                            Time at);
/// Returns the direction of @p cue in base_link, left positive [rad].
[[nodiscard]] double bearingOf(const HeatCue& cue, const Pose& baseInOdom);
/// Returns the place of the heat in the odometry's frame [m], if its horizontal distance from the camera is
/// @p away [m].
[[nodiscard]] Eigen::Vector3d placeOf(const HeatCue& cue, double away);
/// Returns the height of the heat above the robot's ground [m], if it is as far from the camera as @p place
/// (in odom), seen from above.
[[nodiscard]] double heightAt(const HeatCue& cue, const Eigen::Vector2d& place, const Pose& baseInOdom);

/// Returns a robot's pose on its ground: without roll, pitch and height.
[[nodiscard]] Eigen::Isometry2d flat(const Pose& baseInOdom);

}  // namespace leitstand
