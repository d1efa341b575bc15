#pragma once

#include <optional>
#include <string>

#include "core/robot/robot_description.h"

namespace leitstand::simulation {

/// Where a sensor sits and what it is called.
struct SensorPlace {
    std::string key;                 ///< of the description
    std::string frame;               ///< of its samples
    Pose inBase = Pose::Identity();  ///< of that frame, unturned
};

/// The sensor of the first stream of @p role (and of @p key, when given). A stream without a sensor has the
/// one that @p usual names; what the description leaves out is as in @p usual. Empty when the description has
/// streams, but none such.
[[nodiscard]] std::optional<SensorPlace> placeOf(const RobotDescription& robot, StreamRole role,
                                                 const std::string& key, const SensorPlace& usual);

/// Rotation of a camera that looks along x, in optical axes: x right, y down, z ahead (REP 103).
[[nodiscard]] Eigen::Matrix3d opticalAxes();
/// Rotation of a camera below a mirror: its picture's middle is straight below, its top ahead.
[[nodiscard]] Eigen::Matrix3d mirrorAxes();
/// @p place for a camera with the axes of @p axes: when its frame is not optical but stands like base_link (z
/// up), pictures are of a frame FRAME_optical in it.
[[nodiscard]] SensorPlace opticalPlace(const SensorPlace& place, const Eigen::Matrix3d& axes);

}  // namespace leitstand::simulation
