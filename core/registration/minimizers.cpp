#include "core/registration/minimizers.h"

#include <limits>
#include <vector>

#include "core/base/words.h"

namespace leitstand {
namespace {

NormalEquations plane(const Pairing& pairing, const Pose& pose, const Eigen::Vector3d& centre,
                      double /*kernel*/) {
    return planeEquations(pairing, pose, centre);
}

}  // namespace

MinimizerRow rowOf(Minimizer minimizer) {
    MinimizerRow row;
    row.minimizer = minimizer;
    switch (minimizer) {
        case Minimizer::Svd:
            row.key = "svd";
            row.name = translatable("leitstand::RegistrationSettings", "Points · SVD");
            row.hint = translatable(
                "leitstand::RegistrationSettings",
                "Point to point, closed form by singular value decomposition (Arun, Huang & Blostein 1987).");
            row.closedForm = &fitBySvd;
            break;
        case Minimizer::Quaternion:
            row.key = "quaternion";
            row.name = translatable("leitstand::RegistrationSettings", "Points · unit quaternion");
            row.hint = translatable("leitstand::RegistrationSettings",
                                    "Point to point, closed form by unit quaternions (Horn 1987).");
            row.closedForm = &fitByQuaternion;
            break;
        case Minimizer::Orthonormal:
            row.key = "orthonormal";
            row.name = translatable("leitstand::RegistrationSettings", "Points · orthonormal matrix");
            row.hint = translatable(
                "leitstand::RegistrationSettings",
                "Point to point, closed form by orthonormal matrices (Horn, Hilden & Negahdaripour 1988).");
            row.closedForm = &fitByOrthonormal;
            break;
        case Minimizer::DualQuaternion:
            row.key = "dual-quaternion";
            row.name = translatable("leitstand::RegistrationSettings", "Points · dual quaternion");
            row.hint =
                translatable("leitstand::RegistrationSettings",
                             "Point to point, closed form by dual quaternions (Walker, Shao & Volz 1991).");
            row.closedForm = &fitByDualQuaternion;
            break;
        case Minimizer::Plane:
            row.key = "plane";
            row.name = translatable("leitstand::RegistrationSettings", "Point to plane");
            row.hint = translatable("leitstand::RegistrationSettings",
                                    "Distances to the planes of the reference: fewer steps on walls and "
                                    "floors (Chen & Medioni 1991).");
            row.equations = &plane;
            break;
        case Minimizer::Gicp:
            row.key = "gicp";
            row.name = translatable("leitstand::RegistrationSettings", "Plane to plane (GICP)");
            row.hint =
                translatable("leitstand::RegistrationSettings",
                             "Distances between small planes of both scans: fewest steps, hardly depends on "
                             "the maximum distance (Segal, Haehnel & Thrun 2009).");
            row.equations = &gicpEquations;
            row.heedsKernel = true;
            row.sourceNormals = true;
            row.pairVariance = GicpAcrossVariance;
            break;
    }
    return row;
}

std::span<const MinimizerRow> minimizers() {
    static const std::vector<MinimizerRow> rows = [] {
        std::vector<MinimizerRow> known;
        // A value without a case above has no row; the compiler warns of a named one.
        for (unsigned value = 0; value <= std::numeric_limits<std::uint8_t>::max(); ++value) {
            const MinimizerRow row = rowOf(static_cast<Minimizer>(value));
            if (row.key != nullptr) known.push_back(row);
        }
        return known;
    }();
    return rows;
}

}  // namespace leitstand
