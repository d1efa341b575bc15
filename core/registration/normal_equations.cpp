#include "core/registration/normal_equations.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <Eigen/Cholesky>

#include "core/base/parallel.h"
#include "core/registration/gicp_sums.h"

namespace leitstand {
namespace {

/// Returns the sum of the chunks, in their order.
NormalEquations joined(const std::vector<NormalEquations>& chunks, const Eigen::Vector3d& centre) {
    NormalEquations sum;
    sum.centre = centre;
    for (const NormalEquations& chunk : chunks) {
        sum.hessian += chunk.hessian;
        sum.gradient += chunk.gradient;
        sum.cost += chunk.cost;
    }
    return sum;
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
    return joined(chunks, centre);
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

double deviationAcross(const Pairing& pairing, const Pose& sourceInTarget) {
    constexpr double OfMedian = 1.4826;
    const Eigen::Matrix3f rotation = sourceInTarget.linear().cast<float>();
    const Eigen::Vector3f translation = sourceInTarget.translation().cast<float>();
    const PointCloud &source = pairing.source(), &target = pairing.target();
    std::vector<float> distances;
    distances.reserve(source.size());
    for (std::size_t i = 0; i < source.size(); ++i) {
        const Partner& partner = pairing.partners()[i];
        if (partner.index < 0) continue;
        const auto index = static_cast<std::size_t>(partner.index);
        if (target.normals[index].isZero()) continue;
        const Eigen::Vector3f apart = rotation * source.points[i] + translation - target.points[index];
        distances.push_back(std::abs(target.normals[index].dot(apart)));
    }
    if (distances.empty()) return 0.0;
    const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
    std::nth_element(distances.begin(), middle, distances.end());
    return OfMedian * static_cast<double>(*middle);
}

NormalEquations gicpEquations(const Pairing& pairing, const Pose& sourceInTarget,
                              const Eigen::Vector3d& centre, double kernel) {
    const std::size_t count = pairing.partners().size();
    std::vector<NormalEquations> chunks((count + Pairing::Grain - 1) / Pairing::Grain);
    parallelFor(count, Pairing::Grain, pairing.threads(), [&](std::size_t first, std::size_t last) {
        chunks[first / Pairing::Grain] = gicpSums(pairing, sourceInTarget, centre, kernel, first, last);
    });
    return joined(chunks, centre);
}

}  // namespace leitstand
