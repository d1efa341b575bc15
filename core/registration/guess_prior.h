#pragma once

#include <optional>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/registration/normal_equations.h"
#include "core/registration/pairing.h"

namespace leitstand {

/// What is known of the source's pose besides the pairs: the guess, and how far it may be off. It counts only
/// in directions that the pairs' surfaces leave open (solution remapping: Zhang, Kaess & Singh 2016; Tuna et
/// al. 2023). There it counts as much as it is surer than the pairs, so that surfaces which hold a direction
/// only weakly are not lost.
struct GuessPrior {
    Eigen::Matrix<double, 6, 1>
        deviation;           ///< standard deviations: translation [m], then rotation [rad], target's axes
    double openBelow = 0.1;  ///< certainty (as IcpResult::certainty) below which it counts in a direction ...
    double heldBelow = 0.02;  ///< ... and below which it alone counts: noise of normals gives as much
    double alike = 30.0;      ///< pairs with a common error, as of one surface
    /// Where the pairs hold a direction weakly and pull the source this many deviations away, the guess
    /// counts half. Farther away it counts less (Cauchy): wheels slip.
    double outlier = 3.0;
};

/// GuessPrior as a term of the normal equations, for one stage of an alignment.
class GuessTerm {
public:
    GuessTerm(const GuessPrior& prior, const Pose& guess) : m_prior(prior), m_guess(guess) {}

    /// Finds the open directions of the pairs that @p pairing has at @p pose.
    void look(const Pairing& pairing, const Pose& pose, double maxDistance);
    /// Adds the term to @p equations at @p pose. The variance @p across is that of a pair across its surface,
    /// by the weights of the equations, times their own unit [1], see NormalEquations.
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
