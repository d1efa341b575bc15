#pragma once

#include <cstdint>
#include <limits>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/event/candidate_sample.h"
#include "core/mapping/seen_points.h"

namespace leitstand {

/// A cue, and the estimated place of the thing that it shows.
struct PlacedCue {
    Cue cue;
    FindSample::Kind what = FindSample::Kind::Victim;
    Eigen::Vector3d inMap = Eigen::Vector3d::Zero();           ///< [m]
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();  ///< map frame [m2]
    /// Position of the camera that saw it, in the map [m]; NaN: it came by no ray.
    Eigen::Vector3d from = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
    double reach = 0.0;  ///< not 0: the cue came by no ray and supports things within this of the robot [m]
    std::uint64_t scan = 0;  ///< key scan from which it was seen and with which it moves; 0: none
};

/// Standard deviations of what makes up a place.
struct PlacingSettings {
    double pixel = 0.01;     ///< of a ray's direction, besides the blob's own size [rad]
    double heading = 0.012;  ///< of the robot's heading and its camera's mounting [rad]
    double pose = 0.03;      ///< of the robot's place while its scans fit [m]
    double doubted = 0.15;   ///< of the robot's place while they do not fit [m]
    double surface = 0.2;    ///< of a range: depth of the object behind what the laser sees, such as foil [m]
};

/// Sets the place and covariance of @p cue to where @p ray (in the map) meets @p hit. @p spread: half the
/// angle that the seen thing covers [rad]. @p certainPose: the robot's scans fit.
void placeByRay(PlacedCue& cue, const Ray& ray, const RayHit& hit, double spread, bool certainPose,
                const PlacingSettings& settings = {});

}  // namespace leitstand
