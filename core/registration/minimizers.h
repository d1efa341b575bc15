#pragma once

#include <cstdint>
#include <span>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/registration/closed_forms.h"
#include "core/registration/normal_equations.h"
#include "core/registration/pairing.h"

namespace leitstand {

/// What an ICP step minimises.
enum class Minimizer : std::uint8_t {
    Svd,             ///< point to point, Arun, Huang & Blostein 1987
    Quaternion,      ///< point to point, Horn 1987
    Orthonormal,     ///< point to point, Horn, Hilden & Negahdaripour 1988
    DualQuaternion,  ///< point to point, Walker, Shao & Volz 1991
    Plane,           ///< point to plane, Chen & Medioni 1991 (needs the target's normals)
    Gicp,            ///< plane to plane, Segal, Haehnel & Thrun 2009 (needs both normals)
};

/// All that is to be known of a minimiser; exactly one of the two functions is set.
struct MinimizerRow {
    Minimizer minimizer = Minimizer::Gicp;
    const char* key = nullptr;   ///< in files and on leitstandctl's command line
    const char* name = nullptr;  ///< for operators; both are translated in MinimizerTexts
    const char* hint = nullptr;  ///< what it does and where it comes from
    /// The best motion for the pairs, at once.
    Fit (*closedForm)(const PairSums& pairs) = nullptr;
    /// A step of Gauss and Newton; @p centre and @p kernel [m] as of gicpEquations().
    NormalEquations (*equations)(const Pairing& pairing, const Pose& sourceInTarget,
                                 const Eigen::Vector3d& centre, double kernel) = nullptr;
    bool heedsKernel = false;    ///< its equations do
    bool sourceNormals = false;  ///< it needs them, beside the target's, which equations always need
    double pairVariance = 1.0;   ///< of a pair across its surface, as its equations weigh it (GuessTerm)
};

inline constexpr const char* MinimizerTexts = "leitstand::RegistrationSettings";  ///< context

/// Of @p minimizer.
[[nodiscard]] MinimizerRow rowOf(Minimizer minimizer);
/// Of all, in the order in which they are offered.
[[nodiscard]] std::span<const MinimizerRow> minimizers();

}  // namespace leitstand
