#pragma once

#include <cstddef>
#include <deque>
#include <optional>

#include <Eigen/Core>

#include "core/base/pose.h"

namespace leitstand {

/// Where a scan was taken, by odometry and in the map, and how the robot moved while it was taken.
struct ScanMotion {
    Pose sensorInMap = Pose::Identity();   ///< pose by registration
    Pose sensorInOdom = Pose::Identity();  ///< by odometry and the configured mount
    Pose sensorInBase = Pose::Identity();  ///< pose as configured
    /// Mean velocity and yaw rate of the base during the scan, by odometry, in the base's frame [m/s, rad/s].
    Eigen::Vector2d velocity = Eigen::Vector2d::Zero();
    double yawRate = 0.0;
};

/// How far a scanner's mount is from the configured mount, and how late its stamps are.
struct MountError {
    /// x and y in the base [m], yaw [rad], delay of the stamps [s].
    Eigen::Vector4d value = Eigen::Vector4d::Zero();
    Eigen::Vector4d deviation = Eigen::Vector4d::Zero();  ///< standard deviations of `value`
};

/// Estimates position, heading and clock of a scanner from the difference between two motions: that of
/// odometry and that of its scans. If the scanner is turned, the robot seems to drift sideways on a straight
/// path. If it is shifted, the scanner swings when the robot turns. If its stamps are late, the scans lag
/// when the robot changes its turn rate. The scale of odometry's distances and turns is estimated as well.
///
/// After Censi et al., Simultaneous Calibration of Odometry and Sensor Parameters, 2013; the clock as in
/// Rehder et al., 2016.
class ScannerMount {
public:
    /// Adds the scan @p now, to which the robot drove from the scan that was added before. Both scans must
    /// fit the map.
    void add(const ScanMotion& now);
    /// Call when the motion to the next scan is not known, or when scans of the robot were moved in the map.
    void breakOff() { m_from.reset(); }

    [[nodiscard]] std::size_t pairs() const { return m_pairs.size(); }
    /// Returns the error; empty before there are enough pairs.
    [[nodiscard]] std::optional<MountError> estimate() const;

private:
    /// The four of MountError::value, and the scales of odometry's distances and turns.
    static constexpr int Unknowns = 6;
    /// The equations of a pair of scans: rows * unknowns = seen. Each row is divided by its expected standard
    /// deviation.
    struct Pair {
        Eigen::Matrix<double, 3, Unknowns> rows;
        Eigen::Vector3d seen;
    };
    [[nodiscard]] static Pair pairOf(const ScanMotion& from, const ScanMotion& to);

    std::optional<ScanMotion> m_from;
    std::deque<Pair> m_pairs;
};

}  // namespace leitstand
