#pragma once

#include <Eigen/Core>

#include "core/base/pose.h"

namespace leitstand {

/// Estimates how a scanner leans against its configured mount, by comparing gravity with the map. The map
/// itself may be tilted: this tilt stays as the robot turns, while the scanner's lean turns with the robot. A
/// Kalman filter estimates both.
class ScannerLean {
public:
    /// Adds a scan registered to @p scanInMap. @p up: against gravity, in the scan's frame, by the inertial
    /// unit. @p way: distance since the last scan [m].
    void add(const Pose& scanInMap, const Pose& sensorInBase, const Eigen::Vector3d& up, double way);
    /// Notes that the scan of the last add() entered the map at @p scanInMap. @p from: its pose in add(). The
    /// next scans are matched with it and others, so that they follow a share of the turn from @p from to
    /// @p scanInMap.
    void entered(const Pose& from, const Pose& scanInMap, const Eigen::Vector3d& up);
    /// Forgets the map's tilt, but not the lean: the robot continues elsewhere, or scans were moved under it.
    void mapMoved();
    /// Returns @p up without the scanner's lean, as far as the lean is known. @p up: against gravity as the
    /// inertial unit reports it, in the scan's frame.
    [[nodiscard]] Eigen::Vector3d corrected(const Eigen::Vector3d& up, const Pose& sensorInBase) const;

    /// Roll and pitch of the scanner in the robot's base, less the configured ones [rad].
    [[nodiscard]] Eigen::Vector2d lean() const { return m_state.tail<2>(); }
    /// Standard deviations of lean() [rad].
    [[nodiscard]] Eigen::Vector2d deviation() const;

private:
    Eigen::Vector4d m_state = Eigen::Vector4d::Zero();  ///< the map's tilt (x and y of its z axis), the lean
    Eigen::Matrix4d m_covariance = first();

    [[nodiscard]] static Eigen::Matrix4d first();
};

}  // namespace leitstand
