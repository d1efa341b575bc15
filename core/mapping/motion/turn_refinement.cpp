#include "core/mapping/motion/turn_refinement.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "core/cloud/filters/cell_table.h"

namespace leitstand {
namespace {

constexpr double Behind = 0.5;  ///< cosine to a ray that meets a surface from behind: a wall's other side

using Matrix12 = Eigen::Matrix<double, 12, 12>;
using Vector12 = Eigen::Matrix<double, 12, 1>;

/// A point of a turn, and when it was seen: -0.5 at the first shot, 0.5 at the last one.
struct TimedPoint {
    Eigen::Vector3d point;
    double moment;
};

double shareOf(const Scan& scan, std::size_t row) {
    return static_cast<double>(row) / static_cast<double>(scan.rows - 1);
}

/// Returns points of @p scan, spread over space, at most as many as @p settings allow.
std::vector<TimedPoint> sampled(const Scan& scan, const TurnRefinementSettings& settings) {
    std::vector<std::size_t> spread;
    detail::CellTable cells(settings.spacing);
    for (std::size_t i = 0; i < scan.points.size(); ++i) {
        const double range = scan.points[i].cast<double>().norm();
        if (!(range >= settings.minRange && range <= settings.maxRange)) continue;
        if (cells.cellOf(scan.points[i]) == spread.size()) spread.push_back(i);
    }
    const std::size_t count = std::min(spread.size(), static_cast<std::size_t>(std::max(0, settings.points)));
    std::vector<TimedPoint> points;
    points.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t at = spread[i * spread.size() / count];
        const std::size_t row = at / static_cast<std::size_t>(scan.columns);
        points.push_back({scan.points[at].cast<double>(), shareOf(scan, row) - 0.5});
    }
    return points;
}

TurnDrift driftOf(const Vector12& unknowns, const Vector12& scale) {
    const Vector12 drift = unknowns.cwiseProduct(scale);
    return {drift.head<6>(), drift.tail<6>()};
}

/// The linearised problem at a drift, per pair.
struct Equations {
    Matrix12 hessian = Matrix12::Zero();
    Vector12 gradient = Vector12::Zero();
    double cost = 0.0;  ///< mean squared distance of all points; those without a partner count as the limit
    int pairs = 0;
};

/// The estimation problem. The drift is scaled so that all its components move points about as far.
class DriftProblem {
public:
    DriftProblem(std::vector<TimedPoint> points, const LocalMap& local, const Pose& scanInMap, double outlier)
        : m_points(std::move(points)), m_local(local), m_scanInMap(scanInMap), m_outlier(outlier) {
        double squares = 0.0;
        for (const TimedPoint& one : m_points) squares += one.point.squaredNorm();
        const double reach = std::sqrt(squares / static_cast<double>(std::max<std::size_t>(1, size())));
        TurnDrift::Twist twist = TurnDrift::Twist::Ones();
        twist.tail<3>() /= std::max(reach, 0.1);
        m_scale << twist, std::sqrt(12.0) * twist;  // moments have a deviation of 1 / sqrt(12)
    }

    [[nodiscard]] std::size_t size() const { return m_points.size(); }
    [[nodiscard]] const Vector12& scale() const { return m_scale; }

    [[nodiscard]] Equations at(const Vector12& unknowns, double maxDistance) const {
        const TurnDrift drift = driftOf(unknowns, m_scale);
        const double maxSquared = maxDistance * maxDistance;
        Equations sum;
        double weights = 0.0;
        for (const TimedPoint& one : m_points) {
            const Pose correction = drift.at(one.moment + 0.5);
            const Eigen::Vector3d turned = correction.linear() * one.point;
            const Eigen::Vector3d inMap = m_scanInMap * (turned + correction.translation());
            const Neighbour nearest = m_local.search->nearest(inMap.cast<float>(), Label::Unlabelled,
                                                              static_cast<float>(maxSquared));
            if (!nearest.found()) {
                sum.cost += maxSquared;
                continue;
            }
            const auto target = static_cast<std::size_t>(nearest.index);
            const Eigen::Vector3d normalInMap = m_local.cloud.normals[target].cast<double>();
            if (!(normalInMap.squaredNorm() > 0.5)) continue;  // the surface there is unknown
            if (normalInMap.dot((inMap - m_scanInMap.translation()).normalized()) > Behind) {
                sum.cost += maxSquared;
                continue;
            }
            const double distance = normalInMap.dot(inMap - m_local.cloud.points[target].cast<double>());
            const Eigen::Vector3d normal = m_scanInMap.linear().transpose() * normalInMap;
            TurnDrift::Twist now;
            now << normal, turned.cross(normal);
            Vector12 row;
            row << now, one.moment * now;
            row = row.cwiseProduct(m_scale);
            const double weight = 1.0 / (1.0 + std::pow(distance / m_outlier, 2));
            sum.hessian.noalias() += weight * row * row.transpose();
            sum.gradient += weight * distance * row;
            sum.cost += distance * distance;
            weights += weight;
            ++sum.pairs;
        }
        if (weights > 0.0) {
            sum.hessian /= weights;
            sum.gradient /= weights;
        }
        sum.cost /= static_cast<double>(std::max<std::size_t>(1, size()));
        return sum;
    }

private:
    std::vector<TimedPoint> m_points;
    const LocalMap& m_local;
    const Pose& m_scanInMap;
    double m_outlier;
    Vector12 m_scale;
};

bool within(const TurnDrift::Twist& twist, const TurnRefinementSettings& settings) {
    return twist.head<3>().norm() <= settings.mostWay && twist.tail<3>().norm() <= settings.mostTurned;
}

}  // namespace

Pose TurnDrift::at(double share) const {
    return poseFromTwist(middle + (share - 0.5) * whole);
}

std::optional<TurnDrift> turnDrift(const Scan& scan, const LocalMap& local, const Pose& scanInMap,
                                   const TurnRefinementSettings& settings) {
    const bool inGrid =
        scan.rows > 1 && scan.columns > 0 &&
        scan.points.size() == static_cast<std::size_t>(scan.rows) * static_cast<std::size_t>(scan.columns);
    const bool surfaces = local.search && local.cloud.normals.size() == local.cloud.points.size();
    if (!inGrid || !surfaces || !scanInMap.matrix().allFinite() || settings.maxDistances.empty())
        return std::nullopt;
    const DriftProblem problem(sampled(scan, settings), local, scanInMap, settings.outlier);
    // The pose is known by all points; its change is new.
    Vector12 hold = Vector12::Constant(settings.hold);
    hold.head<6>() *= 0.1;
    Vector12 unknowns = Vector12::Zero();
    for (const double maxDistance : settings.maxDistances) {
        const Equations equations = problem.at(unknowns, maxDistance);
        if (equations.pairs < settings.leastPairs) return std::nullopt;
        Matrix12 hessian = equations.hessian;
        hessian.diagonal() += hold;
        unknowns -= hessian.ldlt().solve(equations.gradient + hold.cwiseProduct(unknowns));
        const TurnDrift drift = driftOf(unknowns, problem.scale());
        if (!unknowns.allFinite() || !within(drift.middle, settings) || !within(drift.whole, settings))
            return std::nullopt;
    }
    const double nearest = settings.maxDistances.back();
    const Equations before = problem.at(Vector12::Zero(), nearest), after = problem.at(unknowns, nearest);
    if (after.pairs < settings.leastPairs || !(after.cost <= (1.0 - settings.leastGain) * before.cost))
        return std::nullopt;
    const Eigen::SelfAdjointEigenSolver<Matrix12> information(after.hessian, Eigen::EigenvaluesOnly);
    if (!(information.eigenvalues()[0] >= settings.leastCertainty)) return std::nullopt;
    return driftOf(unknowns, problem.scale());
}

Scan straightened(const Scan& scan, const TurnDrift& drift) {
    Scan result = scan;
    const Pose lastInFrame = drift.at(1.0);
    const auto columns = static_cast<std::size_t>(scan.columns);
    for (std::size_t row = 0; row < static_cast<std::size_t>(scan.rows); ++row) {
        const Eigen::Isometry3f motion = (lastInFrame.inverse() * drift.at(shareOf(scan, row))).cast<float>();
        for (std::size_t i = row * columns; i < (row + 1) * columns; ++i)
            result.points[i] = motion * scan.points[i];
    }
    return result;
}

}  // namespace leitstand
