#pragma once

#include <span>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/cloud/scan.h"

namespace leitstand {

struct CloudSample;
struct RangesSample;

/// Returns the frame in which a plane laser at @p laserInBase is mapped: its own, turned over about x if it
/// hangs upside down. So z points up for all lasers.
[[nodiscard]] Pose uprightLaser(const Pose& laserInBase);

/// Returns whether a plane laser at @p laserInBase scans about level, upside down or not. What looks at the
/// ground or scans upright shows no floor plan.
[[nodiscard]] bool isLevel(const Pose& laserInBase);

/// Returns the echoes of @p ranges, each with its time, in the frame uprightLaser() of a laser at
/// @p laserInBase. Left out are rays without an echo and those that hit the edges of two surfaces at once.
/// Rays count as shot all at once if the sample's time step cannot be right (not finite, not above 0, or a
/// turn of more than a second).
[[nodiscard]] CloudSample cloudOf(const RangesSample& ranges, const Pose& laserInBase);

/// Returns the cloud for matching of a plane laser's echoes @p points, in the order of its rays, z up [m]. A
/// plane says nothing on height, roll and pitch. The cloud adds what holds in buildings: walls stand upright,
/// and the floor is level. Each square of @p edge [m] with echoes becomes two points of an upright wall,
/// 0.4 m above and below, and a point of a level floor. So a scan keeps height and attitude of those that it
/// is matched with, and all that works on clouds works on it.
[[nodiscard]] PointCloud wallsAndFloor(std::span<const Eigen::Vector3f> points, double edge);

}  // namespace leitstand
