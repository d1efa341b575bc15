#pragma once

#include <Eigen/Core>

#include "core/base/pose.h"

namespace leitstand {

/// Estimates how a scanner leans against its configured mount, by comparing gravity with the map. The map's
/// own tilt stays as the robot turns; the scanner's lean turns with the robot. A Kalman filter of both.
class ScannerLean {
public:
    /// Adds a scan registered to @p scanInMap. @p up: against gravity, in the scan's frame, by the inertial
    /// unit. @p way: distance since the last scan [m].
    void add(const Pose& scanInMap, const Pose& sensorInBase, const Eigen::Vector3d& up, double way);
    /// Notes that the newest scan entered the map, turned to @p scanInMap, as one of many that the next scans
    /// are matched with. @p from: its pose in add().
    void entered(const Pose& from, const Pose& scanInMap, const Eigen::Vector3d& up);
    /// Forgets the map's tilt: the robot goes on from elsewhere, or scans were moved under it.
    void mapMoved();
    /// Returns the direction against gravity for a unit that reports @p up, both in the scan's frame, as far
    /// as the lean is known.
    [[nodiscard]] Eigen::Vector3d corrected(const Eigen::Vector3d& up, const Pose& sensorInBase) const;

    /// Roll and pitch of the scanner in the robot's base beyond the configured ones [rad].
    [[nodiscard]] Eigen::Vector2d lean() const { return m_state.tail<2>(); }
    /// One deviation of each [rad].
    [[nodiscard]] Eigen::Vector2d deviation() const;

private:
    Eigen::Vector4d m_state = Eigen::Vector4d::Zero();  ///< the map's tilt (x and y of its z axis), the lean
    Eigen::Matrix4d m_covariance = first();

    [[nodiscard]] static Eigen::Matrix4d first();
};

}  // namespace leitstand
