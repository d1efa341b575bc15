#include "core/registration/guess_prior.h"

#include <algorithm>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "core/registration/evaluation.h"

namespace leitstand {

void GuessTerm::look(const Pairing& pairing, const Pose& pose, double maxDistance) {
    const PairInformation found =
        informationOf(pairing, pose, pairing.sums().sourceMean(), maxDistance * maxDistance);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> solver(found.information);
    Eigen::Matrix<double, 6, 1> unscaled = Eigen::Matrix<double, 6, 1>::Ones();
    if (found.radius > 0.0) unscaled.tail<3>().setConstant(1.0 / found.radius);
    for (m_open = 0; m_open < 6; ++m_open) {
        constexpr double All = 100.0;
        const double certainty = 3.0 * solver.eigenvalues()[m_open];  // they rise
        if (certainty >= m_prior.openBelow) break;
        m_directions.col(m_open) = unscaled.asDiagonal() * solver.eigenvectors().col(m_open);
        m_weights[m_open] = certainty < m_prior.heldBelow ? All : 1.0;
    }
}

void GuessTerm::add(NormalEquations& equations, const Pose& pose, std::size_t pairs, double across) const {
    if (m_open == 0 || pairs == 0) return;
    // Motion of the source since the guess: about the equations' centre, as their steps are.
    const Pose moved = pose * m_guess.inverse();
    const Eigen::AngleAxisd turn(moved.linear());
    Eigen::Matrix<double, 6, 1> step;
    step << equations.centre - moved.inverse() * equations.centre, turn.angle() * turn.axis();
    // The deviation is of the source's origin.
    Eigen::Matrix<double, 6, 6> toOrigin = Eigen::Matrix<double, 6, 6>::Identity();
    const Eigen::Vector3d arm = pose.translation() - equations.centre;
    toOrigin.topRightCorner<3, 3>() << 0, arm.z(), -arm.y(), -arm.z(), 0, arm.x(), arm.y(), -arm.x(), 0;
    // The equations' weights take @p across as a pair's variance. Its real variance follows from their cost,
    // and is at least Least squared.
    constexpr double Least = 0.005;  // [m]
    const double variance =
        std::max(2.0 * across * equations.cost / static_cast<double>(pairs), Least * Least);
    const double unit = variance * m_prior.alike / across;
    // Adds only what the guess knows along the open directions, as the origin moves by them, one after
    // another.
    const Eigen::Matrix<double, 6, 6> root = m_prior.deviation.cwiseInverse().asDiagonal() * toOrigin;
    Eigen::Matrix<double, 6, 6> along;
    for (int i = 0; i < m_open; ++i) {
        along.col(i) = root * m_directions.col(i);
        for (int before = 0; before < i; ++before)
            along.col(i) -= along.col(before).dot(along.col(i)) * along.col(before);
        along.col(i).normalize();
        const Eigen::Matrix<double, 6, 1> row = root.transpose() * along.col(i);
        const double off = row.dot(step), outliers = off / m_prior.outlier;
        const double weight = unit * (m_weights[i] > 1.0 ? m_weights[i] : 1.0 / (1.0 + outliers * outliers));
        equations.hessian.noalias() += weight * row * row.transpose();
        equations.gradient.noalias() += weight * off * row;
    }
}

}  // namespace leitstand
