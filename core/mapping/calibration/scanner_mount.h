#pragma once

#include <cstddef>
#include <deque>
#include <optional>

#include <Eigen/Core>

#include "core/base/pose.h"

namespace leitstand {

/// A scan as odometry and the map tell of it.
struct ScanMotion {
    Pose sensorInMap = Pose::Identity();   ///< as registered
    Pose sensorInOdom = Pose::Identity();  ///< by odometry and what is said of the mount
    Pose sensorInBase = Pose::Identity();  ///< what is said
    /// Of the base, by odometry, the mean over the scan, in the base [m/s, rad/s].
    Eigen::Vector2d velocity = Eigen::Vector2d::Zero();
    double yawRate = 0.0;
};

/// Where a scanner sits against where it is said to, and how late its stamps are.
struct MountError {
    /// x and y in the base [m], yaw [rad], by how much its stamps are too late [s].
    Eigen::Vector4d value = Eigen::Vector4d::Zero();
    Eigen::Vector4d deviation = Eigen::Vector4d::Zero();  ///< one deviation of each
};

/// Place, heading and clock of a scanner from how the ways of odometry and of its scans differ: what sits
/// turned seems to drift aside on a straight way, what sits aside swings as the robot turns, what is late
/// lags as the robot turns faster or slower. The scale of odometry's ways and turns is found beside (after
/// Censi et al., Simultaneous Calibration of Odometry and Sensor Parameters, 2013; the clock as in Rehder
/// et al., 2016).
class ScannerMount {
public:
    /// The robot came from the scan before to @p now, both fit.
    void add(const ScanMotion& now);
    /// How the robot came to its next scan is not known, or scans were moved under it.
    void breakOff() { m_from.reset(); }

    [[nodiscard]] std::size_t pairs() const { return m_pairs.size(); }
    /// Empty before enough pairs told.
    [[nodiscard]] std::optional<MountError> estimate() const;

private:
    static constexpr int Unknowns = 6;  ///< MountError::value, scale of odometry's ways and of its turns
    /// What a pair of scans says: rows * unknowns = seen, in expected deviations.
    struct Pair {
        Eigen::Matrix<double, 3, Unknowns> rows;
        Eigen::Vector3d seen;
    };
    [[nodiscard]] static Pair pairOf(const ScanMotion& from, const ScanMotion& to);

    std::optional<ScanMotion> m_from;
    std::deque<Pair> m_pairs;
};

}  // namespace leitstand
