#pragma once

#include <optional>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/registration/normal_equations.h"
#include "core/registration/pairing.h"

namespace leitstand {

/// What is known of the source's pose besides the pairs: the guess, and how far it may be off. The guess
/// counts only in directions that the pairs' surfaces leave open (solution remapping: Zhang, Kaess & Singh
/// 2016; Tuna et al. 2023). There, guess and pairs are weighted by their variances, so that surfaces which
/// hold a direction only weakly still count.
struct GuessPrior {
    /// Standard deviations of the source's origin: translation [m], then rotation [rad], target's axes.
    Eigen::Matrix<double, 6, 1> deviation;
    /// Certainty of a direction (as IcpResult::certainty) below which the guess counts in it.
    double openBelow = 0.1;
    /// Certainty of a direction below which the guess alone counts in it: noise of normals gives as much.
    double heldBelow = 0.02;
    double alike = 30.0;  ///< number of pairs that share an error, as those on one surface do
    /// Where the pairs hold a direction weakly and pull the source this many deviations away from the guess,
    /// the guess counts half. Farther away it counts less (Cauchy): wheels slip.
    double outlier = 3.0;
};

/// GuessPrior as a term of the normal equations, for one stage of an alignment.
class GuessTerm {
public:
    GuessTerm(const GuessPrior& prior, const Pose& guess) : m_prior(prior), m_guess(guess) {}

    /// Finds the directions that the pairs of @p pairing leave open at @p pose. Pairs within @p maxDistance
    /// [m] count.
    void look(const Pairing& pairing, const Pose& pose, double maxDistance);
    /// Adds the term to @p equations at @p pose. @p pairs: number of pairs that the equations are made of.
    /// @p across: variance of a pair across its surface that their weights assume
    /// (MinimizerRow::pairVariance).
    void add(NormalEquations& equations, const Pose& pose, std::size_t pairs, double across) const;

    [[nodiscard]] int open() const { return m_open; }  ///< number of open directions

private:
    GuessPrior m_prior;
    Pose m_guess;
    int m_open = 0;
    Eigen::Matrix<double, 6, 6>
        m_directions;  ///< columns: steps that move no point along its normal, the most open first
    Eigen::Matrix<double, 6, 1> m_weights;  ///< factor on the guess's certainty along each direction
};

}  // namespace leitstand
