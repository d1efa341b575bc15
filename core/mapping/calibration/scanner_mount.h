#pragma once

#include <cstddef>
#include <deque>
#include <optional>

#include <Eigen/Core>

#include "core/base/pose.h"

namespace leitstand {

/// Where a scan was taken by odometry and by the map, and how the robot moved meanwhile.
struct ScanMotion {
    Pose sensorInMap = Pose::Identity();   ///< as registered
    Pose sensorInOdom = Pose::Identity();  ///< by odometry and the configured mount
    Pose sensorInBase = Pose::Identity();  ///< as configured
    /// Velocity and yaw rate of the base by odometry, in the base, mean over the scan [m/s, rad/s].
    Eigen::Vector2d velocity = Eigen::Vector2d::Zero();
    double yawRate = 0.0;
};

/// How far a scanner's mount is from the configured one, and how late its stamps are.
struct MountError {
    /// x and y in the base [m], yaw [rad], by how much its stamps are too late [s].
    Eigen::Vector4d value = Eigen::Vector4d::Zero();
    Eigen::Vector4d deviation = Eigen::Vector4d::Zero();  ///< standard deviations of `value`
};

/// Estimates position, heading and clock of a scanner from the difference between odometry's motion and that
/// of its scans. A turned scanner seems to drift sideways on a straight path. A shifted one swings as the
/// robot turns. A late one lags as the robot turns faster or slower. The scale of odometry's distances and
/// turns is estimated as well. After Censi et al., Simultaneous Calibration of Odometry and Sensor
/// Parameters, 2013; the clock as in Rehder et al., 2016.
class ScannerMount {
public:
    /// Adds the scan @p now. The robot drove to it from the scan added before, and both fit the map.
    void add(const ScanMotion& now);
    /// Notes that the motion to the next scan is not known, or that scans were moved under the robot.
    void breakOff() { m_from.reset(); }

    [[nodiscard]] std::size_t pairs() const { return m_pairs.size(); }
    /// Returns the error; empty before there are enough pairs.
    [[nodiscard]] std::optional<MountError> estimate() const;

private:
    static constexpr int Unknowns = 6;  ///< MountError::value, scale of odometry's distances and of its turns
    /// The equations of a pair of scans: rows * unknowns = seen, each divided by its expected standard
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
