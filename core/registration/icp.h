#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/base/progress.h"
#include "core/cloud/scan.h"
#include "core/cloud/search/search.h"
#include "core/registration/guess_prior.h"
#include "core/registration/minimizers.h"

namespace leitstand {

/// Settings of one alignment.
struct IcpSettings {
    std::vector<double> maxDistances = {0.5};  ///< maximum distances of pairs [m]: one stage for each
    std::optional<double> judgedWithin;  ///< maximum distance of the pairs that rate how well the pose fits
                                         ///< [m]; unless set, that of the last stage
    std::optional<double> minStep;  ///< a stage ends when the pose moves less [m, rad]; unless set, 1e-4 for
                                    ///< minimisers with equations and 1e-5 for point to point, which creeps
    int maxIterations = 500;        ///< in all stages together
    Minimizer minimizer = Minimizer::Gicp;
    int threads = 0;      ///< 0: one per core
    bool facing = false;  ///< whether points on opposite sides of a wall make no pairs (Pairing)
    /// Kernel of the last stage, for minimisers that use one (Gicp). Pairs that are far apart across their
    /// surface then count little (Geman & McClure 1985). The limit is this many times the pairs' deviation
    /// across it, by the median when the stage begins; 0: all count alike.
    double kernel = 0.0;
    std::optional<GuessPrior> prior;  ///< how far the guess may be off; ignored by closed forms
};

/// Why the last stage ended. A later stage that is Degenerate is dropped: the result of the stage before
/// stays.
enum class IcpStop : std::uint8_t { Converged, LimitCycle, IterationLimit, Degenerate, Cancelled };

/// Wall-clock time spent in the parts of an alignment [s].
struct IcpTimes {
    double pairing = 0.0, minimising = 0.0, evaluating = 0.0;
    std::vector<double> stages;  ///< one for each stage that was begun, without the evaluation
};

/// Result of an alignment, and how far to trust it.
struct IcpResult {
    Pose pose = Pose::Identity();  ///< source in target
    bool converged = false;        ///< Converged, or a LimitCycle smaller than 1 mm and 0.02 degrees
    IcpStop stop = IcpStop::IterationLimit;
    int iterations = 0;
    double rms = 0.0;          ///< root mean squared distance of the pairs within judgedWithin [m]
    double inlierRatio = 0.0;  ///< share of source points with a pair within judgedWithin
    double overlap = 0.0;      ///< share of source points with a partner within OverlapDistance
    /// Information on the pose from the pairs' normals, per pair: mean of j j^T with j = [n, (q - c) x n /
    /// r]. q is a source point, c the mean of the paired ones, r their root mean squared distance from c.
    /// Translation comes first, in the target's frame. Zero when no pair has a normal.
    Eigen::Matrix<double, 6, 6> information = Eigen::Matrix<double, 6, 6>::Zero();
    /// Three times the smallest eigenvalue of the information: 1 when surfaces face all directions alike, 0
    /// when a motion is not constrained at all. Below UncertainBelow the pose is not certain().
    double certainty = 0.0;
    /// Eigenvector of the smallest eigenvalue of the information, unit length.
    Eigen::Matrix<double, 6, 1> weakest = Eigen::Matrix<double, 6, 1>::Zero();
    int open = 0;  ///< number of directions in which IcpSettings::prior counted
    IcpTimes times;

    static constexpr double OverlapDistance = 0.10;  ///< [m]
    static constexpr double UncertainBelow = 0.02;
    [[nodiscard]] bool certain() const { return certainty >= UncertainBelow; }
};

/// Moves @p source onto @p target, starting at @p guess (Besl & McKay 1992; paper, section 2.1). Each
/// iteration finds the closest pairs and takes the minimiser's step; stages follow one another. @p search is
/// over @p target. Plane and Gicp need normals of the target, Gicp also of the source; without them they end
/// at once as Degenerate. The result does not depend on the number of threads.
[[nodiscard]] IcpResult align(const PointCloud& target, const Search& search, const PointCloud& source,
                              const Pose& guess, const IcpSettings& settings = {},
                              const Progress& progress = {});

}  // namespace leitstand
