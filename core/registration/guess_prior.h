#pragma once

#include <optional>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/registration/normal_equations.h"
#include "core/registration/pairing.h"

namespace leitstand {

/// What is known of the source's pose besides the pairs: the guess, and how wrong it may be. The guess is
/// used only in directions that the pairs' surfaces leave open (solution remapping: Zhang, Kaess & Singh
/// 2016; Tuna et al. 2023). In these directions, guess and pairs are weighted by their variances, so that
/// surfaces which hold a direction weakly still have an effect.
struct GuessPrior {
    /// Standard deviations of the source's origin: translation [m], then rotation [rad], along the target's
    /// axes.
    Eigen::Matrix<double, 6, 1> deviation;
    /// The guess is used in directions whose certainty (as IcpResult::certainty) is below this.
    double openBelow = 0.1;
    /// Below this certainty of a direction, only the guess is used in it: noise of normals alone gives as
    /// much.
    double heldBelow = 0.02;
    double alike = 30.0;  ///< number of pairs that share an error, as pairs on one surface do
    /// If pairs that hold a direction weakly pull the source this many deviations away from the guess, the
    /// guess has half its weight. Farther away it has less (Cauchy), since wheels slip.
    double outlier = 3.0;
};

/// GuessPrior as a term of the normal equations, for one stage of an alignment.
class GuessTerm {
public:
    GuessTerm(const GuessPrior& prior, const Pose& guess) : m_prior(prior), m_guess(guess) {}

    /// Finds the directions that the pairs of @p pairing leave open at @p pose. Only pairs within
    /// @p maxDistance [m] are used.
    void look(const Pairing& pairing, const Pose& pose, double maxDistance);
    /// Adds the term for @p pose to @p equations, which are made of @p pairs pairs. @p across: the variance
    /// of a pair across its surface on which their weights are based (MinimizerRow::pairVariance).
    void add(NormalEquations& equations, const Pose& pose, std::size_t pairs, double across) const;

    [[nodiscard]] int open() const { return m_open; }  ///< number of open directions

private:
    GuessPrior m_prior;
    Pose m_guess;
    int m_open = 0;
    Eigen::Matrix<double, 6, 6>
        m_directions;  ///< columns: steps along which surfaces resist least, the most open first
    Eigen::Matrix<double, 6, 1> m_weights;  ///< factor for the guess's certainty in each direction
};

}  // namespace leitstand
