#pragma once

#include <optional>
#include <string>

#include "core/robot/robot_description.h"

namespace leitstand::simulation {

/// Where a sensor sits and what it is called.
struct SensorPlace {
    std::string key;                 ///< in the description
    std::string frame;               ///< of its samples
    Pose inBase = Pose::Identity();  ///< pose of that frame, unturned
};

/// Returns the place of the sensor of the first stream of @p role (and of @p key, when given). When the
/// stream names no sensor, it is the one of @p usual. What the description leaves out is as in @p usual.
/// Empty: the description has streams, but none of that role and key.
[[nodiscard]] std::optional<SensorPlace> placeOf(const RobotDescription& robot, StreamRole role,
                                                 const std::string& key, const SensorPlace& usual);

/// Returns the rotation of a camera that looks along x, in optical axes: x right, y down, z ahead (REP 103).
[[nodiscard]] Eigen::Matrix3d opticalAxes();
/// Returns the rotation of a camera below a mirror: the middle of its picture is straight below, the top
/// ahead.
[[nodiscard]] Eigen::Matrix3d mirrorAxes();
/// Returns @p place for a camera with optical @p axes. When the frame of @p place stands like base_link (z
/// up), pictures get a frame FRAME_optical in it; any other frame is taken as optical already.
[[nodiscard]] SensorPlace opticalPlace(const SensorPlace& place, const Eigen::Matrix3d& axes);

}  // namespace leitstand::simulation
