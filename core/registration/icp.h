#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/base/progress.h"
#include "core/scan/scan.h"
#include "core/search/search.h"

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

/// Settings of one alignment.
struct IcpSettings {
    std::vector<double> maxDistances = {
        0.5};                 ///< pairs farther apart are dropped [m]; stages, one after another
    double minStep = 1e-5;    ///< a stage ends when the pose moves less [m, rad]
    int maxIterations = 500;  ///< over all stages
    Minimizer minimizer = Minimizer::Gicp;
    int threads = 0;  ///< 0: one per core
};

/// Why the last stage ended.
enum class IcpStop : std::uint8_t { Converged, LimitCycle, IterationLimit, Degenerate, Cancelled };

/// Wall-clock time spent in the parts of an alignment [s].
struct IcpTimes {
    double pairing = 0.0, minimising = 0.0, evaluating = 0.0;
};

/// What an alignment found and how far it is to be trusted.
struct IcpResult {
    Pose pose = Pose::Identity();  ///< source in target
    bool converged = false;        ///< true for Converged and for a LimitCycle below 1 mm and 0.02 degrees
    IcpStop stop = IcpStop::IterationLimit;
    int iterations = 0;
    double rms = 0.0;          ///< of the pairs at the end [m]
    double inlierRatio = 0.0;  ///< pairs within the last maxDistance over source points
    double overlap = 0.0;      ///< source points with a partner within 10 cm, over source points
    Eigen::Matrix<double, 6, 6> information =
        Eigen::Matrix<double, 6, 6>::Zero();  ///< of the pose, translation
                                              ///< first, per pair
    double certainty = 0.0;                   ///< smallest eigenvalue of the normalised information, 0 to 1
    IcpTimes times;
};

}  // namespace leitstand
