#include "core/mapping/calibration/scanner_lean.h"

#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/LU>

namespace leitstand {
namespace {

constexpr double MostTilt = degrees(3), MostLean = degrees(3);  ///< prior deviations [rad]
constexpr double Drift = degrees(0.03);                         ///< of the map's tilt per scan [rad] ...
constexpr double DriftOfWay = degrees(0.06);                    ///< ... and per root of a metre [rad]
constexpr double UnitDeviation = degrees(0.2);                  ///< of the inertial unit's up direction [rad]

/// Share of a scan's turn on entering the map that shows in the next scans, which are matched with a dozen.
constexpr double Follows = 0.15;
constexpr double Knocked = 5.0;  ///< deviations; beyond, the scanner was knocked, or the unit is wrong

}  // namespace

Eigen::Matrix4d ScannerLean::first() {
    return Eigen::Vector4d(MostTilt * MostTilt, MostTilt * MostTilt, MostLean * MostLean, MostLean * MostLean)
        .asDiagonal();
}

void ScannerLean::add(const Pose& scanInMap, const Pose& sensorInBase, const Eigen::Vector3d& up,
                      double way) {
    const Eigen::Matrix3d baseInMap = scanInMap.linear() * sensorInBase.linear().transpose();
    const Eigen::Vector3d upInBase = sensorInBase.linear() * up;
    const Eigen::Vector2d disagreement = (scanInMap.linear() * up).head<2>();
    m_covariance.topLeftCorner<2, 2>().diagonal().array() +=
        Drift * Drift + DriftOfWay * DriftOfWay * std::abs(way);
    // A scanner that is turned by l sees up turned by -l: the reported direction is up + l x up.
    Eigen::Matrix<double, 2, 4> seen;
    seen.leftCols<2>().setIdentity();
    for (int axis = 0; axis < 2; ++axis)
        seen.col(2 + axis) = (baseInMap * Eigen::Vector3d::Unit(axis).cross(upInBase)).head<2>();
    const Eigen::Matrix2d expected =
        seen * m_covariance * seen.transpose() + UnitDeviation * UnitDeviation * Eigen::Matrix2d::Identity();
    const Eigen::Vector2d unexpected = disagreement - seen * m_state;
    if (unexpected.dot(expected.ldlt().solve(unexpected)) > Knocked * Knocked) {
        *this = {};  // what was known is no longer true
        return;
    }
    const Eigen::Matrix<double, 4, 2> gain = m_covariance * seen.transpose() * expected.inverse();
    m_state += gain * unexpected;
    m_covariance = (Eigen::Matrix4d::Identity() - gain * seen) * m_covariance;
    m_covariance = 0.5 * (m_covariance + m_covariance.transpose()).eval();
}

void ScannerLean::entered(const Pose& from, const Pose& scanInMap, const Eigen::Vector3d& up) {
    m_state.head<2>() += Follows * ((scanInMap.linear() - from.linear()) * up).head<2>();
}

void ScannerLean::mapMoved() {
    m_covariance.topRightCorner<2, 2>().setZero();
    m_covariance.bottomLeftCorner<2, 2>().setZero();
    m_covariance.topLeftCorner<2, 2>() = first().topLeftCorner<2, 2>();
}

Eigen::Vector3d ScannerLean::corrected(const Eigen::Vector3d& up, const Pose& sensorInBase) const {
    const Eigen::Vector3d lean(m_state[2], m_state[3], 0.0);
    return (up - (sensorInBase.linear().transpose() * lean).cross(up)).normalized();
}

Eigen::Vector2d ScannerLean::deviation() const {
    return m_covariance.diagonal().tail<2>().cwiseSqrt();
}

}  // namespace leitstand
