#include "core/registration/normal_equations.h"

#include <cmath>

#include <Eigen/Cholesky>

#include "core/base/parallel.h"

namespace leitstand {
namespace {

constexpr double AcrossVariance = 1e-3;

Eigen::Matrix3d crossMatrix(const Eigen::Vector3d& v) {
    Eigen::Matrix3d m;
    m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
    return m;
}

/// Inverse covariance of a pair with unit normals @p a and @p b. Its eigenvectors are the bisectors of the
/// normals and their common perpendicular, so no matrix is inverted.
Eigen::Matrix3d pairInformation(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    constexpr double k = 1.0 - AcrossVariance;
    const double c = std::abs(a.dot(b));
    const Eigen::Vector3d other = a.dot(b) < 0.0 ? Eigen::Vector3d(-b) : b;
    Eigen::Matrix3d information = 0.5 * Eigen::Matrix3d::Identity();
    const Eigen::Vector3d between = a + other, across = a - other;
    const double betweenSquared = 2.0 + 2.0 * c, acrossSquared = 2.0 - 2.0 * c;
    information += (1.0 / (2.0 - k * (1.0 + c)) - 0.5) / betweenSquared * between * between.transpose();
    if (acrossSquared > 1e-12) {
        information += (1.0 / (2.0 - k * (1.0 - c)) - 0.5) / acrossSquared * across * across.transpose();
    }
    return information;
}

/// Runs @p add(equations, i, source point, target point) over all pairs and joins the chunks in order.
template <class Add>
NormalEquations gather(const Pairing& pairing, const Pose& sourceInTarget, const Eigen::Vector3d& centre,
                       Add add) {
    const std::size_t count = pairing.partners().size();
    std::vector<NormalEquations> chunks((count + Pairing::Grain - 1) / Pairing::Grain);
    parallelFor(count, Pairing::Grain, pairing.threads(), [&](std::size_t first, std::size_t last) {
        NormalEquations equations;
        for (std::size_t i = first; i < last; ++i) {
            const Partner& partner = pairing.partners()[i];
            if (partner.index < 0) continue;
            const Eigen::Vector3d source = sourceInTarget * pairing.source().points[i].cast<double>();
            const auto target = static_cast<std::size_t>(partner.index);
            add(equations, i, target, source - centre,
                Eigen::Vector3d(source - pairing.target().points[target].cast<double>()));
        }
        chunks[first / Pairing::Grain] = equations;
    });
    NormalEquations sum;
    sum.centre = centre;
    for (const NormalEquations& chunk : chunks) {
        sum.hessian += chunk.hessian;
        sum.gradient += chunk.gradient;
        sum.cost += chunk.cost;
    }
    return sum;
}

}  // namespace

std::optional<Pose> NormalEquations::solve() const {
    const Eigen::LDLT<Eigen::Matrix<double, 6, 6>> factors(hessian);
    const double largest = factors.vectorD().cwiseAbs().maxCoeff();
    if (factors.info() != Eigen::Success || !(factors.vectorD().minCoeff() > 1e-12 * largest))
        return std::nullopt;
    const Eigen::Matrix<double, 6, 1> step = factors.solve(-gradient);
    if (!step.allFinite()) return std::nullopt;
    Pose motion = poseFromTwist(step);
    motion.translation() += centre - motion.linear() * centre;
    return motion;
}

NormalEquations planeEquations(const Pairing& pairing, const Pose& sourceInTarget,
                               const Eigen::Vector3d& centre) {
    const auto& normals = pairing.target().normals;
    return gather(pairing, sourceInTarget, centre,
                  [&](NormalEquations& equations, std::size_t, std::size_t target, const Eigen::Vector3d& arm,
                      const Eigen::Vector3d& residual) {
                      const Eigen::Vector3d normal = normals[target].cast<double>();
                      Eigen::Matrix<double, 6, 1> row;
                      row << normal, arm.cross(normal);
                      const double distance = normal.dot(residual);
                      equations.hessian.noalias() += row * row.transpose();
                      equations.gradient += distance * row;
                      equations.cost += 0.5 * distance * distance;
                  });
}

NormalEquations gicpEquations(const Pairing& pairing, const Pose& sourceInTarget,
                              const Eigen::Vector3d& centre) {
    const auto& targetNormals = pairing.target().normals;
    const auto& sourceNormals = pairing.source().normals;
    const Eigen::Matrix3d rotation = sourceInTarget.linear();
    return gather(pairing, sourceInTarget, centre,
                  [&](NormalEquations& equations, std::size_t source, std::size_t target,
                      const Eigen::Vector3d& arm, const Eigen::Vector3d& residual) {
                      Eigen::Vector3d a = rotation * sourceNormals[source].cast<double>();
                      Eigen::Vector3d b = targetNormals[target].cast<double>();
                      // A point whose surface is unknown takes that of its partner.
                      if (a.squaredNorm() < 0.5) a = b;
                      if (b.squaredNorm() < 0.5) b = a;
                      const Eigen::Matrix3d w = a.squaredNorm() < 0.5
                                                    ? Eigen::Matrix3d(0.5 * Eigen::Matrix3d::Identity())
                                                    : pairInformation(a, b);
                      // d residual / d step = [I, -[arm]x]
                      const Eigen::Matrix3d turn = -crossMatrix(arm);
                      const Eigen::Matrix3d wTurn = w * turn;
                      const Eigen::Vector3d wResidual = w * residual;
                      equations.hessian.topLeftCorner<3, 3>() += w;
                      equations.hessian.topRightCorner<3, 3>() += wTurn;
                      equations.hessian.bottomLeftCorner<3, 3>() += wTurn.transpose();
                      equations.hessian.bottomRightCorner<3, 3>().noalias() += turn.transpose() * wTurn;
                      equations.gradient.head<3>() += wResidual;
                      equations.gradient.tail<3>().noalias() += turn.transpose() * wResidual;
                      equations.cost += 0.5 * residual.dot(wResidual);
                  });
}

}  // namespace leitstand
