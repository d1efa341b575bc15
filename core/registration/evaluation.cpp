#include "core/registration/evaluation.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Eigenvalues>

#include "core/base/parallel.h"

namespace leitstand {
namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

/// The surface normal at a pair in the target's frame: the target's, or else the source's; zero when unknown.
Eigen::Vector3d normalOf(const Pairing& pairing, const Pose& pose, std::size_t source, std::size_t target) {
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    if (!pairing.target().normals.empty()) normal = pairing.target().normals[target].cast<double>();
    if (normal.squaredNorm() < 0.5 && !pairing.source().normals.empty()) {
        normal = pose.linear() * pairing.source().normals[source].cast<double>();
    }
    return normal;
}

/// Sums of informationOf() over a chunk of pairs.
struct InformationSums {
    Matrix6 products = Matrix6::Zero();
    double squaredRadii = 0.0;
    std::size_t count = 0;
};

InformationSums informationSums(const Pairing& pairing, const Pose& pose, const Eigen::Vector3d& centre,
                                double maxSquared, std::size_t first, std::size_t last) {
    InformationSums sums;
    for (std::size_t i = first; i < last; ++i) {
        const Partner& partner = pairing.partners()[i];
        if (partner.index < 0 || partner.squaredDistance >= maxSquared) continue;
        const Eigen::Vector3d normal = normalOf(pairing, pose, i, static_cast<std::size_t>(partner.index));
        if (normal.squaredNorm() < 0.5) continue;
        const Eigen::Vector3d arm = pose * pairing.source().points[i].cast<double>() - centre;
        Vector6 row;
        row << normal, arm.cross(normal);
        sums.products.noalias() += row * row.transpose();
        sums.squaredRadii += arm.squaredNorm();
        ++sums.count;
    }
    return sums;
}

}  // namespace

PairInformation informationOf(const Pairing& pairing, const Pose& pose, const Eigen::Vector3d& centre,
                              double maxSquared) {
    const std::size_t pairs = pairing.partners().size();
    std::vector<InformationSums> chunks((pairs + Pairing::Grain - 1) / Pairing::Grain);
    parallelFor(pairs, Pairing::Grain, pairing.threads(), [&](std::size_t first, std::size_t last) {
        chunks[first / Pairing::Grain] = informationSums(pairing, pose, centre, maxSquared, first, last);
    });
    InformationSums sums;
    for (const InformationSums& chunk : chunks) {
        sums.products += chunk.products;
        sums.squaredRadii += chunk.squaredRadii;
        sums.count += chunk.count;
    }
    if (sums.count == 0 || sums.squaredRadii <= 0.0) return {};
    const auto n = static_cast<double>(sums.count);
    Vector6 scale = Vector6::Ones();
    const double radius = std::sqrt(sums.squaredRadii / n);
    scale.tail<3>() *= 1.0 / radius;
    return {scale.asDiagonal() * (sums.products / n) * scale.asDiagonal(), radius};
}

void evaluate(Pairing& pairing, double paired, double maxDistance, IcpResult& result) {
    // If the last step was below the limit, the pairs before it are still those of the pose.
    const double needed = std::max(maxDistance, IcpResult::OverlapDistance);
    if (result.stop != IcpStop::Converged || paired < needed) pairing.update(result.pose, needed);
    const double maxSquared = maxDistance * maxDistance;
    constexpr double overlapSquared = IcpResult::OverlapDistance * IcpResult::OverlapDistance;
    std::size_t inliers = 0, overlapping = 0;
    double squares = 0.0;
    for (const Partner& partner : pairing.partners()) {
        if (partner.index < 0) continue;
        if (partner.squaredDistance < overlapSquared) ++overlapping;
        if (partner.squaredDistance >= maxSquared) continue;
        ++inliers;
        squares += static_cast<double>(partner.squaredDistance);
    }
    if (inliers == 0) return;
    const auto points = static_cast<double>(pairing.source().size());
    result.rms = std::sqrt(squares / static_cast<double>(inliers));
    result.inlierRatio = static_cast<double>(inliers) / points;
    result.overlap = static_cast<double>(overlapping) / points;
    result.information =
        informationOf(pairing, result.pose, pairing.sums().sourceMean(), maxSquared).information;
    const Eigen::SelfAdjointEigenSolver<Matrix6> solver(result.information);
    result.certainty = std::clamp(3.0 * solver.eigenvalues()[0], 0.0, 1.0);
    result.weakest = solver.eigenvectors().col(0);
}

}  // namespace leitstand
