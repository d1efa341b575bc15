#include "core/mapping/calibration/scanner_mount.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <Eigen/LU>

namespace leitstand {
namespace {

// A pair ends where the robot has moved or turned so far.
constexpr double PairWay = 0.35;             // [m]
constexpr double PairTurn = degrees(12);     // [rad]
constexpr double MostTurned = degrees(120);  // [rad]
constexpr std::size_t LeastPairs = 100;      // about 35 m of path
constexpr std::size_t MostPairs = 400;       // the newest
constexpr double Place = 0.003;              // deviation of a scan's position in the map [m] ...
constexpr double Heading = degrees(0.1);     // ... and of its heading [rad]
constexpr double OfWay = 0.02;               // wheels slip by this share of the distance ...
constexpr double OfTurn = 0.04;              // ... and of the turn,
constexpr double SlipInTurn = 0.02;          // and sideways by so much in a turn [m/rad]
constexpr double Outlier = 2.0;              // deviations; what is farther off weighs less (Huber)
constexpr int Rounds = 8;

/// Prior deviations of the unknowns.
constexpr std::array<double, 6> Expected = {0.1, 0.1, degrees(5), 0.2, 0.1, 0.1};

double yawOf(const Eigen::Matrix3d& rotation) {
    return std::atan2(rotation(1, 0) - rotation(0, 1), rotation(0, 0) + rotation(1, 1));
}

Eigen::Vector2d turnedLeft(const Eigen::Vector2d& v) {
    return {-v.y(), v.x()};
}

}  // namespace

ScannerMount::Pair ScannerMount::pairOf(const ScanMotion& from, const ScanMotion& to) {
    const Pose& mount = from.sensorInBase;
    const Pose byOdometry =
        mount * (from.sensorInOdom.inverse() * to.sensorInOdom) * to.sensorInBase.inverse();
    const Pose byScans = from.sensorInMap.inverse() * to.sensorInMap;
    const double turn = yawOf(mount.linear() * byScans.linear() * mount.linear().transpose());
    const double tooFar = std::remainder(yawOf(byOdometry.linear()) - turn, 2.0 * std::numbers::pi);
    const Eigen::Matrix2d turned = Eigen::Rotation2Dd(turn).toRotationMatrix();
    const Eigen::Matrix2d lever = Eigen::Matrix2d::Identity() - turned;
    const Eigen::Vector2d way = (mount.linear() * byScans.translation()).head<2>();
    const Eigen::Vector2d base = lever * mount.translation().head<2>() + way;
    // Odometry turns too far steadily, so half of the error shows in the direction of motion.
    const Eigen::Vector2d went =
        Eigen::Rotation2Dd(-0.5 * tooFar) * Eigen::Vector2d(byOdometry.translation().head<2>());
    Pair pair;
    pair.seen << went - base, tooFar;
    pair.rows.setZero();
    pair.rows.topLeftCorner<2, 2>() = lever;
    pair.rows.block<2, 1>(0, 2) = turnedLeft(way);
    pair.rows.block<2, 1>(0, 3) =
        turned * to.velocity - from.velocity - 0.5 * (from.yawRate + to.yawRate) * turnedLeft(went);
    pair.rows(2, 3) = to.yawRate - from.yawRate;
    pair.rows.block<2, 1>(0, 4) = base;
    pair.rows(2, 5) = turn;
    const double place = std::hypot(Place, OfWay * base.norm(), SlipInTurn * turn);
    const double heading = std::hypot(Heading, OfTurn * turn);
    const Eigen::Vector3d weight(1.0 / place, 1.0 / place, 1.0 / heading);
    pair.rows = (weight.asDiagonal() * pair.rows).eval();
    pair.seen = weight.cwiseProduct(pair.seen);
    return pair;
}

void ScannerMount::add(const ScanMotion& now) {
    if (!m_from) {
        m_from = now;
        return;
    }
    const Pose moved = m_from->sensorInMap.inverse() * now.sensorInMap;
    const double turned = Eigen::AngleAxisd(moved.linear()).angle();
    if (moved.translation().norm() < PairWay && turned < PairTurn) return;
    // A pair with a large turn between its scans holds little information.
    if (turned < MostTurned) m_pairs.push_back(pairOf(*m_from, now));
    if (m_pairs.size() > MostPairs) m_pairs.pop_front();
    m_from = now;
}

std::optional<MountError> ScannerMount::estimate() const {
    using Vector = Eigen::Matrix<double, Unknowns, 1>;
    using Matrix = Eigen::Matrix<double, Unknowns, Unknowns>;
    if (m_pairs.size() < LeastPairs) return std::nullopt;
    Vector found = Vector::Zero();
    Matrix information;
    double squares = 0.0, count = 0.0;
    for (int round = 0; round < Rounds; ++round) {
        information.setZero();
        for (int i = 0; i < Unknowns; ++i)
            information(i, i) = 1.0 / (Expected[std::size_t(i)] * Expected[std::size_t(i)]);
        Vector right = Vector::Zero();
        squares = count = 0.0;
        for (const Pair& pair : m_pairs) {
            const Eigen::Vector3d left = pair.seen - pair.rows * found;
            for (int row = 0; row < 3; ++row) {
                const double off = std::abs(left[row]);
                const double weight = off > Outlier ? Outlier / off : 1.0;
                information += weight * pair.rows.row(row).transpose() * pair.rows.row(row);
                right += weight * pair.rows.row(row).transpose() * pair.seen[row];
                squares += weight * off * off;
                count += 1.0;
            }
        }
        found = information.ldlt().solve(right);
    }
    // Consecutive pairs share errors of odometry and map. They hold less information than independent ones.
    constexpr double Shared = 2.0, LeastScatter = 0.5;
    const double scatter = Shared * std::max(LeastScatter, std::sqrt(squares / count));
    const Matrix covariance = information.inverse();
    MountError error;
    error.value = found.head<4>();
    error.deviation = scatter * covariance.diagonal().head<4>().cwiseSqrt();
    return error;
}

}  // namespace leitstand
