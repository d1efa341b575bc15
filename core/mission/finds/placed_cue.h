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
    Eigen::Vector3d inMap = Eigen::Vector3d::Zero();           ///< estimated place [m]
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();  ///< covariance in the map's frame [m2]
    /// Position of the camera that saw it, in the map [m]; NaN: there is no ray.
    Eigen::Vector3d from = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
    /// If not 0, there is no ray: the cue supports things within this distance of the robot [m].
    double reach = 0.0;
    std::uint64_t scan = 0;  ///< key scan from which it was seen and with which it moves; 0: none
};

/// Standard deviations of the errors of a cue's place.
struct PlacingSettings {
    double pixel = 0.01;     ///< direction of a ray, in addition to the blob's own size [rad]
    double heading = 0.012;  ///< robot's heading and mounting of its camera [rad]
    double pose = 0.03;      ///< robot's place while its scans fit [m]
    double doubted = 0.15;   ///< robot's place while its scans do not fit [m]
    double surface = 0.2;  ///< range: the object may be this far behind what the laser sees, such as foil [m]
};

/// Sets the place and covariance of @p cue to where @p ray (in the map) meets @p hit. @p spread: half the
/// angle that the thing spans [rad]. @p certainPose: whether the robot's scans fit.
void placeByRay(PlacedCue& cue, const Ray& ray, const RayHit& hit, double spread, bool certainPose,
                const PlacingSettings& settings = {});

}  // namespace leitstand
