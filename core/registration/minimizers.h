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
    Plane,           ///< point to plane, Chen & Medioni 1991 (needs normals of the target)
    Gicp,            ///< plane to plane, Segal, Haehnel & Thrun 2009 (needs normals of both clouds)
};

/// Properties of a minimiser; exactly one of the two functions is set.
struct MinimizerRow {
    Minimizer minimizer = Minimizer::Gicp;
    const char* key = nullptr;  ///< name in files and on leitstandctl's command line
    /// Name for operators; name and hint are translated in the context MinimizerTexts.
    const char* name = nullptr;
    const char* hint = nullptr;  ///< for operators: what it does and who published it
    /// Computes the best motion for the pairs directly.
    Fit (*closedForm)(const PairSums& pairs) = nullptr;
    /// Makes the equations of a Gauss-Newton step. @p centre and @p kernel [m] are those of gicpEquations().
    NormalEquations (*equations)(const Pairing& pairing, const Pose& sourceInTarget,
                                 const Eigen::Vector3d& centre, double kernel) = nullptr;
    bool heedsKernel = false;  ///< whether its equations use a kernel
    /// Whether it needs normals of the source; equations always need those of the target.
    bool sourceNormals = false;
    /// Variance of a pair across its surface on which its equations are based; for GuessTerm::add().
    double pairVariance = 1.0;
};

inline constexpr const char* MinimizerTexts = "leitstand::RegistrationSettings";  ///< context of translations

/// The properties of @p minimizer.
[[nodiscard]] MinimizerRow rowOf(Minimizer minimizer);
/// All minimisers, in the order in which they are offered.
[[nodiscard]] std::span<const MinimizerRow> minimizers();

}  // namespace leitstand
