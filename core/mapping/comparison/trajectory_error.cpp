#include "core/mapping/comparison/trajectory_error.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace leitstand {
namespace {

constexpr std::chrono::milliseconds Nearest(250);  ///< true poses that are farther in time are not used
constexpr double Lever = 0.5;                      ///< of a heading, weighed against positions [m]

/// Returns the position of @p pose and a point ahead of it.
std::vector<Eigen::Vector3d> pointsOf(const Pose& pose) {
    return {pose.translation(), pose * Eigen::Vector3d(Lever, 0.0, 0.0)};
}

}  // namespace

std::vector<PosePair> pairsOf(std::span<const StampedPose> estimated, std::span<const StampedPose> truth) {
    std::vector<PosePair> pairs;
    for (const StampedPose& one : estimated) {
        const auto after = std::lower_bound(truth.begin(), truth.end(), one.at,
                                            [](const StampedPose& pose, Time at) { return pose.at < at; });
        if (after == truth.end()) continue;
        if (after->at == one.at) {
            pairs.push_back({one.pose, after->pose});
            continue;
        }
        if (after == truth.begin()) continue;
        const auto before = std::prev(after);
        if (one.at - before->at > Nearest || after->at - one.at > Nearest) continue;
        const double share = std::chrono::duration<double>(one.at - before->at) /
                             std::chrono::duration<double>(after->at - before->at);
        pairs.push_back({one.pose, interpolated(before->pose, after->pose, share)});
    }
    return pairs;
}

std::optional<TrajectoryError> trajectoryError(std::span<const PosePair> pairs) {
    if (pairs.empty()) return std::nullopt;
    Eigen::Vector3d from = Eigen::Vector3d::Zero(), to = Eigen::Vector3d::Zero();
    for (const PosePair& pair : pairs) {
        for (const Eigen::Vector3d& point : pointsOf(pair.estimated)) from += point;
        for (const Eigen::Vector3d& point : pointsOf(pair.truth)) to += point;
    }
    const double count = 2.0 * static_cast<double>(pairs.size());
    from /= count;
    to /= count;
    double along = 0.0, across = 0.0;  // closed form of the best turn in the plane
    for (const PosePair& pair : pairs) {
        const auto estimated = pointsOf(pair.estimated), truth = pointsOf(pair.truth);
        for (std::size_t i = 0; i < estimated.size(); ++i) {
            const Eigen::Vector3d a = estimated[i] - from, b = truth[i] - to;
            along += a.x() * b.x() + a.y() * b.y();
            across += a.x() * b.y() - a.y() * b.x();
        }
    }
    TrajectoryError error;
    error.poses = static_cast<int>(pairs.size());
    error.mapInWorld.linear() =
        Eigen::AngleAxisd(std::atan2(across, along), Eigen::Vector3d::UnitZ()).toRotationMatrix();
    error.mapInWorld.translation() = to - error.mapInWorld.linear() * from;
    for (const PosePair& pair : pairs) {
        const Pose fitted = error.mapInWorld * pair.estimated;
        error.position += (fitted.translation() - pair.truth.translation()).squaredNorm();
        error.rotation += std::pow(angleBetween(fitted, pair.truth), 2);
    }
    error.position = std::sqrt(error.position / error.poses);
    error.rotation = std::sqrt(error.rotation / error.poses);
    return error;
}

}  // namespace leitstand
