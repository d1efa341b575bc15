#include "core/mapping/placement/wall_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Eigenvalues>

namespace leitstand {
namespace {

constexpr int MostIterations = 25;  ///< per stage
constexpr double Converged = 1e-4;  ///< [m, rad]
constexpr double Kernel = 0.05;     ///< residuals beyond count less (Cauchy) [m]
constexpr std::size_t Enough = 20;  ///< pairs

/// Sums over pairs. Turns are about the middle of the view and lengths are in its radius, so that they
/// compare.
struct Sums {
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
    Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
    double weight = 0.0;
    std::size_t pairs = 0;
};

struct Frame {
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();  ///< of the view, its frame
    double radius = 1.0;                               ///< [m]
};

Frame frameOf(const LaserView& view) {
    Frame frame;
    for (const Eigen::Vector2f& point : view.points) frame.middle += point.cast<double>();
    frame.middle /= static_cast<double>(view.points.size());
    double squares = 0.0;
    for (const Eigen::Vector2f& point : view.points)
        squares += (point.cast<double>() - frame.middle).squaredNorm();
    frame.radius = std::max(0.1, std::sqrt(squares / static_cast<double>(view.points.size())));
    return frame;
}

Sums sumsAt(const LaserView& view, const WallMap& map, const FlatPose& pose, const Frame& frame,
            double distance) {
    Sums sums;
    const Eigen::Vector2d middle = pose * frame.middle;
    const auto bound = static_cast<float>(distance * distance);
    for (const Eigen::Vector2f& one : view.points) {
        const Eigen::Vector2d point = pose * one.cast<double>();
        const Eigen::Vector3f query(static_cast<float>(point.x()), static_cast<float>(point.y()), 0.0F);
        const Neighbour wall = map.search->nearest(query, Label::Unlabelled, bound);
        if (!wall.found()) continue;
        const auto index = static_cast<std::size_t>(wall.index);
        const Eigen::Vector2d normal = map.walls.normals[index].head<2>().cast<double>();
        const Eigen::Vector2d on = map.walls.points[index].head<2>().cast<double>();
        const double residual = normal.dot(point - on);
        const Eigen::Vector2d arm = (point - middle) / frame.radius;
        const Eigen::Vector3d row(normal.x(), normal.y(), arm.x() * normal.y() - arm.y() * normal.x());
        const double weight = 1.0 / (1.0 + residual * residual / (Kernel * Kernel));
        sums.information += weight * row * row.transpose();
        sums.gradient += weight * residual * row;
        sums.weight += weight;
        ++sums.pairs;
    }
    return sums;
}

}  // namespace

WallFit fitToWalls(const LaserView& view, const WallMap& map, const FlatPose& guess,
                   const std::vector<double>& distances) {
    WallFit fit;
    fit.pose = guess;
    if (view.points.size() < Enough || !map.search) return fit;
    const Frame frame = frameOf(view);
    using Solver = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>;
    for (const double distance : distances) {
        for (int i = 0; i < MostIterations; ++i) {
            const Sums sums = sumsAt(view, map, fit.pose, frame, distance);
            if (sums.pairs < Enough) break;
            const Solver solver(sums.information / sums.weight);
            Eigen::Vector3d step = Eigen::Vector3d::Zero();
            for (int k = 0; k < 3; ++k) {
                const double value = solver.eigenvalues()[k];
                if (3.0 * value < WallFit::OpenBelow) continue;
                const Eigen::Vector3d along = solver.eigenvectors().col(k);
                step -= along * along.dot(sums.gradient / sums.weight) / value;
            }
            const double turn = std::clamp(step.z() / frame.radius, -0.2, 0.2);
            const Eigen::Vector2d middle = fit.pose * frame.middle + step.head<2>();
            fit.pose.heading += turn;
            fit.pose.place = middle - Eigen::Rotation2Dd(fit.pose.heading) * frame.middle;
            if (step.norm() < Converged) break;
        }
    }
    const Sums last = sumsAt(view, map, fit.pose, frame, WallFit::OverlapDistance);
    fit.overlap = static_cast<double>(last.pairs) / static_cast<double>(view.points.size());
    if (last.pairs < Enough) return fit;
    fit.direction = std::clamp(3.0 * Solver(last.information / last.weight).eigenvalues()[0], 0.0, 1.0);
    double squares = 0.0;
    for (const Eigen::Vector2f& one : view.points) {
        const Eigen::Vector2d point = fit.pose * one.cast<double>();
        const Eigen::Vector3f query(static_cast<float>(point.x()), static_cast<float>(point.y()), 0.0F);
        const Neighbour wall = map.search->nearest(query, Label::Unlabelled,
                                                   static_cast<float>(std::pow(WallFit::OverlapDistance, 2)));
        if (!wall.found()) continue;
        const auto index = static_cast<std::size_t>(wall.index);
        const Eigen::Vector2f off = query.head<2>() - map.walls.points[index].head<2>();
        squares += std::pow(double{map.walls.normals[index].head<2>().dot(off)}, 2);
    }
    fit.rms = std::sqrt(squares / static_cast<double>(last.pairs));
    return fit;
}

}  // namespace leitstand
