#pragma once

#include <Eigen/Core>

#include "core/base/pose.h"

namespace leitstand {

/// Estimates how far a scanner leans from its configured mount, by comparing gravity with the map. The map
/// itself may be tilted. As the robot turns, the tilt of the map stays in the map, and the lean turns with
/// the robot. A Kalman filter estimates both.
class ScannerLean {
public:
    /// Adds a scan registered to @p scanInMap. @p up: upward direction in the scan's frame, from the inertial
    /// unit. @p way: distance since the last scan [m].
    void add(const Pose& scanInMap, const Pose& sensorInBase, const Eigen::Vector3d& up, double way);
    /// Notes that the scan of the last add() entered the map at @p scanInMap, not at @p from, its pose in
    /// add(). Later scans are matched with this scan and with others. So their poses include a part of the
    /// turn from @p from to @p scanInMap.
    void entered(const Pose& from, const Pose& scanInMap, const Eigen::Vector3d& up);
    /// Forgets the map's tilt, but keeps the lean. Call when the robot continues elsewhere in the map, or
    /// when its scans were moved.
    void mapMoved();
    /// Returns @p up corrected by the lean that is known so far. @p up: upward direction in the scan's frame,
    /// from the inertial unit.
    [[nodiscard]] Eigen::Vector3d corrected(const Eigen::Vector3d& up, const Pose& sensorInBase) const;

    /// Roll and pitch of the scanner in the robot's base, minus the configured values [rad].
    [[nodiscard]] Eigen::Vector2d lean() const { return m_state.tail<2>(); }
    /// Standard deviations of lean() [rad].
    [[nodiscard]] Eigen::Vector2d deviation() const;

private:
    /// The x and y of the map's z axis (its tilt), then the lean.
    Eigen::Vector4d m_state = Eigen::Vector4d::Zero();
    Eigen::Matrix4d m_covariance = first();

    [[nodiscard]] static Eigen::Matrix4d first();
};

}  // namespace leitstand
