#include "core/registration/closed_forms.h"

#include <algorithm>

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>

namespace leitstand {
namespace {

// Ratios of singular values of the covariance. Below CollinearRatio the second direction is rounding error. A
// third direction that is mirrored by less than MirrorRatio is noise of points in a plane.
constexpr double CollinearRatio = 1e-7;
constexpr double MirrorRatio = 1e-3;

/// The fit with rotation @p rotation; the translation brings the means together (equation 6).
Fit withRotation(const PairSums& sums, const Eigen::Matrix3d& rotation, FitOutcome outcome) {
    Fit fit;
    fit.outcome = outcome;
    fit.pose.linear() = rotation;
    fit.pose.translation() = sums.targetMean() - rotation * sums.sourceMean();
    return fit;
}

/// Outcome from the singular values s1 >= s2 >= s3 >= 0 of the covariance, whose best orthogonal matrix is a
/// reflection where @p mirrored.
FitOutcome outcomeOf(const Eigen::Vector3d& singular, bool mirrored) {
    if (mirrored && singular[2] > MirrorRatio * (singular[0] + singular[1])) return FitOutcome::Mirror;
    if (!(singular[1] > CollinearRatio * singular[0])) return FitOutcome::Collinear;
    return FitOutcome::Ok;
}

/// The same from the eigenvalues of a quaternion's 4x4 matrix in rising order. Up to a common shift and
/// factor they are -s1-s2+s3, ..., s1-s2-s3, s1+s2+s3. In the mirror case s3 is negative.
FitOutcome outcomeOf(const Eigen::Vector4d& eigenvalues) {
    const double mean = eigenvalues.mean();
    const double scale = eigenvalues[3] - eigenvalues[0];               // 2 (s1 + s2)
    const double third = eigenvalues[3] + eigenvalues[0] - 2.0 * mean;  // 2 s3
    if (third < -2.0 * MirrorRatio * scale) return FitOutcome::Mirror;
    if (!(eigenvalues[3] - eigenvalues[2] > 2.0 * CollinearRatio * scale)) return FitOutcome::Collinear;
    return FitOutcome::Ok;
}

/// Matrix of the product q * r as a function of r, for a quaternion (x, y, z, w).
Eigen::Matrix4d leftProduct(const Eigen::Vector4d& q) {
    Eigen::Matrix4d m;
    m << q[3], -q[2], q[1], q[0],  //
        q[2], q[3], -q[0], q[1],   //
        -q[1], q[0], q[3], q[2],   //
        -q[0], -q[1], -q[2], q[3];
    return m;
}

/// Matrix of the product q * r as a function of q.
Eigen::Matrix4d rightProduct(const Eigen::Vector4d& r) {
    Eigen::Matrix4d m;
    m << r[3], r[2], -r[1], r[0],  //
        -r[2], r[3], r[0], r[1],   //
        r[1], -r[0], r[3], r[2],   //
        -r[0], -r[1], -r[2], r[3];
    return m;
}

Eigen::Vector4d pure(const Eigen::Vector3d& vector) {
    return {vector.x(), vector.y(), vector.z(), 0.0};
}

/// Sum of leftProduct(target) * rightProduct(source) over all pairs, from the sum of source * target^T.
Eigen::Matrix4d quaternionProducts(const Eigen::Matrix3d& product) {
    Eigen::Matrix4d sum = Eigen::Matrix4d::Zero();
    for (int s = 0; s < 3; ++s) {
        for (int t = 0; t < 3; ++t) {
            sum += product(s, t) * leftProduct(pure(Eigen::Vector3d::Unit(t))) *
                   rightProduct(pure(Eigen::Vector3d::Unit(s)));
        }
    }
    return sum;
}

Eigen::Matrix3d rotationOf(const Eigen::Vector4d& q) {
    return Eigen::Quaterniond(q[3], q[0], q[1], q[2]).normalized().toRotationMatrix();
}

constexpr std::size_t FewestPairs = 3;

}  // namespace

Fit fitBySvd(const PairSums& sums) {
    if (sums.count < FewestPairs) return {FitOutcome::TooFewPairs, Pose::Identity()};
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(sums.covariance(), Eigen::ComputeFullU | Eigen::ComputeFullV);
    const double sign = (svd.matrixV() * svd.matrixU().transpose()).determinant() < 0.0 ? -1.0 : 1.0;
    const Eigen::Matrix3d rotation =
        svd.matrixV() * Eigen::Vector3d(1.0, 1.0, sign).asDiagonal() * svd.matrixU().transpose();
    return withRotation(sums, rotation, outcomeOf(svd.singularValues(), sign < 0.0));
}

Fit fitByQuaternion(const PairSums& sums) {
    if (sums.count < FewestPairs) return {FitOutcome::TooFewPairs, Pose::Identity()};
    const Eigen::Matrix4d n = -quaternionProducts(sums.covariance());
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> solver(n);
    return withRotation(sums, rotationOf(solver.eigenvectors().col(3)), outcomeOf(solver.eigenvalues()));
}

Fit fitByOrthonormal(const PairSums& sums) {
    if (sums.count < FewestPairs) return {FitOutcome::TooFewPairs, Pose::Identity()};
    const Eigen::Matrix3d m = sums.covariance().transpose();
    // R = M (M^T M)^(-1/2), where v = M u / |M u| for each eigenvector u of M^T M. The third pair, absent for
    // points in a plane and inverted for mirror images, completes the right-handed frames.
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(m.transpose() * m);
    const Eigen::Vector3d singular = solver.eigenvalues().cwiseMax(0.0).cwiseSqrt().reverse();
    const FitOutcome outcome = outcomeOf(singular, m.determinant() < 0.0);
    Eigen::Matrix3d u, v;
    u.col(0) = solver.eigenvectors().col(2);
    u.col(1) = solver.eigenvectors().col(1);
    u.col(2) = u.col(0).cross(u.col(1));
    if (!(singular[0] > 0.0)) return withRotation(sums, Eigen::Matrix3d::Identity(), outcome);
    v.col(0) = (m * u.col(0)).normalized();
    const Eigen::Vector3d second = m * u.col(1);
    const Eigen::Vector3d across = second - v.col(0).dot(second) * v.col(0);
    v.col(1) = outcome == FitOutcome::Collinear ? v.col(0).unitOrthogonal() : across.normalized();
    v.col(2) = v.col(0).cross(v.col(1));
    return withRotation(sums, v * u.transpose(), outcome);
}

Fit fitByDualQuaternion(const PairSums& sums) {
    if (sums.count < FewestPairs) return {FitOutcome::TooFewPairs, Pose::Identity()};
    // With q the rotation, p = translation * q / 2 the dual part, and products written as matrices, the error
    // of a pair is e = (L(target) - R(source)) q - 2 p. Its squared sum is least for p = c q / (2 n) with c =
    // sum of (L(target) - R(source)), and q the eigenvector below.
    const double n = sums.weight;
    const Eigen::Matrix4d c = leftProduct(pure(sums.target)) - rightProduct(pure(sums.source));
    const Eigen::Matrix4d a = -2.0 * quaternionProducts(sums.product) + c.transpose() * c / n;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> solver(a);
    const Eigen::Vector4d q = solver.eigenvectors().col(3);
    const Eigen::Vector4d p = c * q / (2.0 * n);
    const Eigen::Vector4d conjugate(-q[0], -q[1], -q[2], q[3]);
    Fit fit;
    fit.outcome = outcomeOf(solver.eigenvalues());
    fit.pose.linear() = rotationOf(q);
    fit.pose.translation() = (2.0 * rightProduct(conjugate) * p).head<3>();
    return fit;
}

}  // namespace leitstand
