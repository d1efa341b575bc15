#pragma once

#include <Eigen/Core>

#include "core/base/pose.h"

namespace leitstand {

/// How a scanner leans against where it is said to sit, from what gravity says against the map: what is the
/// map's own tilt stays as the robot turns, what is the scanner's turns with it. A Kalman filter of both.
class ScannerLean {
public:
    /// A scan was registered to @p scanInMap, where @p up, in its frame, is against gravity as the inertial
    /// unit says; @p way: since the last one [m].
    void add(const Pose& scanInMap, const Pose& sensorInBase, const Eigen::Vector3d& up, double way);
    /// The newest scan entered the map turned to @p scanInMap, as one of many that the next ones are matched
    /// with; @p from: where add() had it.
    void entered(const Pose& from, const Pose& scanInMap, const Eigen::Vector3d& up);
    /// The robot goes on from elsewhere, or scans were moved under it: the map's tilt there is not known.
    void mapMoved();
    /// What is against gravity by a unit that says @p up, in the scan's frame, as far as the lean is known.
    [[nodiscard]] Eigen::Vector3d corrected(const Eigen::Vector3d& up, const Pose& sensorInBase) const;

    /// Roll and pitch by which the scanner is turned in the robot's base beyond what is said of it [rad].
    [[nodiscard]] Eigen::Vector2d lean() const { return m_state.tail<2>(); }
    /// One deviation of each [rad].
    [[nodiscard]] Eigen::Vector2d deviation() const;

private:
    Eigen::Vector4d m_state = Eigen::Vector4d::Zero();  ///< the map's tilt (of its z axis, x and y), the lean
    Eigen::Matrix4d m_covariance = first();

    [[nodiscard]] static Eigen::Matrix4d first();
};

}  // namespace leitstand
