#pragma once

#include <optional>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/registration/normal_equations.h"
#include "core/registration/pairing.h"

namespace leitstand {

/// What is known of the source's pose beside the pairs: the guess, and how far it may be off. It has a say
/// only in directions that the pairs' surfaces leave open (solution remapping: Zhang, Kaess & Singh 2016;
/// Tuna et al. 2023), and there as much as it is surer than the pairs, so that surfaces which hold a
/// direction only a little are not lost.
struct GuessPrior {
    Eigen::Matrix<double, 6, 1>
        deviation;  ///< standard deviations: translation [m], then rotation [rad], target's axes
    double openBelow =
        0.1;  ///< certainty (as IcpResult::certainty) below which it has a say in a direction ...
    double heldBelow = 0.02;  ///< ... and below which it has all: noise of normals alone makes as much
    double alike = 30.0;      ///< so many pairs err alike, being of one surface
    /// Where pairs hold a direction a little, and pull the source so many deviations away, the guess counts
    /// half, or less (Cauchy): wheels slip.
    double outlier = 3.0;
};

/// GuessPrior as a term of the normal equations, for one stage of an alignment.
class GuessTerm {
public:
    GuessTerm(const GuessPrior& prior, const Pose& guess) : m_prior(prior), m_guess(guess) {}

    /// Finds the open directions of the pairs that @p pairing has at @p pose.
    void look(const Pairing& pairing, const Pose& pose, double maxDistance);
    /// Adds the term to @p equations at @p pose. @p across: variance of a pair across its surface by the
    /// weights of the equations, times the equations' own unit [1], see NormalEquations.
    void add(NormalEquations& equations, const Pose& pose, std::size_t pairs, double across) const;

    [[nodiscard]] int open() const { return m_open; }  ///< directions

private:
    GuessPrior m_prior;
    Pose m_guess;
    int m_open = 0;
    Eigen::Matrix<double, 6, 6>
        m_directions;  ///< columns: steps that move nothing along its normal, the most open first
    Eigen::Matrix<double, 6, 1> m_weights;  ///< how many times as sure the guess counts along each
};

}  // namespace leitstand
