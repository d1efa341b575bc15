#pragma once

#include <optional>
#include <string>

#include "core/robot/robot_description.h"

namespace leitstand::simulation {

/// Where a sensor is mounted and what it is called.
struct SensorPlace {
    std::string key;                 ///< its key in the description
    std::string frame;               ///< frame of its samples
    Pose inBase = Pose::Identity();  ///< pose of that frame when it is not turned
};

/// Returns the place of the sensor of the first stream with @p role (and @p key, if given). If the stream
/// names no sensor, it is that of @p usual. What the description leaves out is taken from @p usual. Empty:
/// the description has streams, but none with that role and key.
[[nodiscard]] std::optional<SensorPlace> placeOf(const RobotDescription& robot, StreamRole role,
                                                 const std::string& key, const SensorPlace& usual);

/// Returns the rotation of the optical axes of a camera that looks along x: x right, y down, z ahead (REP
/// 103).
[[nodiscard]] Eigen::Matrix3d opticalAxes();
/// Returns the rotation of a camera below a mirror: the middle of its picture is straight below, its top is
/// ahead.
[[nodiscard]] Eigen::Matrix3d mirrorAxes();
/// Returns @p place for a camera with the optical @p axes. If the frame of @p place is oriented like
/// base_link (z up), pictures get a frame FRAME_optical in it. Any other frame is assumed to be optical
/// already.
[[nodiscard]] SensorPlace opticalPlace(const SensorPlace& place, const Eigen::Matrix3d& axes);

}  // namespace leitstand::simulation
