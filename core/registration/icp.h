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
    std::vector<double> maxDistances = {0.5};  ///< maximum distance of a pair [m], one for each stage
    /// Maximum distance of the pairs that rate the fit [m]; if not set, that of the last stage.
    std::optional<double> judgedWithin;
    /// A stage ends when the pose moves less than this [m, rad]; if not set, 1e-4 for minimisers with
    /// equations and 1e-5 for point to point, which moves slowly.
    std::optional<double> minStep;
    int maxIterations = 500;  ///< largest number of iterations in all stages together
    Minimizer minimizer = Minimizer::Gicp;
    int threads = 0;      ///< number of threads; 0: one per core
    bool facing = false;  ///< whether points on opposite sides of a wall are never paired (Pairing)
    /// Kernel of the last stage, for minimisers that use one (Gicp). It gives little weight to pairs that are
    /// far apart across their surface (Geman & McClure 1985). The limit is this number times the pairs'
    /// deviation across the surface, from the median when the stage begins. 0: all pairs have the same
    /// weight.
    double kernel = 0.0;
    std::optional<GuessPrior> prior;  ///< how wrong the guess may be; ignored by closed forms
};

/// Why the last stage ended. If a later stage is Degenerate, it is dropped and the result of the previous
/// stage is kept.
enum class IcpStop : std::uint8_t { Converged, LimitCycle, IterationLimit, Degenerate, Cancelled };

/// Wall-clock time spent in the parts of an alignment [s].
struct IcpTimes {
    double pairing = 0.0, minimising = 0.0, evaluating = 0.0;
    std::vector<double> stages;  ///< one for each stage that was begun; without evaluation
};

/// Result of an alignment, and how reliable it is.
struct IcpResult {
    Pose pose = Pose::Identity();  ///< pose of the source in the target's frame
    bool converged = false;        ///< Converged, or a LimitCycle smaller than 1 mm and 0.02 degrees
    IcpStop stop = IcpStop::IterationLimit;
    int iterations = 0;
    double rms = 0.0;          ///< root mean square distance of the pairs within judgedWithin [m]
    double inlierRatio = 0.0;  ///< share of source points with a pair within judgedWithin
    double overlap = 0.0;      ///< share of source points with a partner within OverlapDistance
    /// Information about the pose from the pairs' normals, per pair: the mean of j j^T with j = [n, (q - c) x
    /// n / r]. Here q is a source point, c the mean of the paired source points, and r their root mean square
    /// distance from c. Translation comes first, in the target's frame. Zero when no pair has a normal.
    Eigen::Matrix<double, 6, 6> information = Eigen::Matrix<double, 6, 6>::Zero();
    /// Three times the smallest eigenvalue of the information. It is 1 when surfaces face all directions
    /// equally, and 0 when a motion is not constrained at all. Below UncertainBelow, certain() is false.
    double certainty = 0.0;
    /// Eigenvector of the smallest eigenvalue of the information, unit length.
    Eigen::Matrix<double, 6, 1> weakest = Eigen::Matrix<double, 6, 1>::Zero();
    int open = 0;  ///< number of directions in which IcpSettings::prior was used
    IcpTimes times;

    static constexpr double OverlapDistance = 0.10;  ///< largest distance between partners for `overlap` [m]
    static constexpr double UncertainBelow = 0.02;
    [[nodiscard]] bool certain() const { return certainty >= UncertainBelow; }
};

/// Moves @p source onto @p target, starting at @p guess (Besl & McKay 1992; paper, section 2.1). Each
/// iteration finds the closest pairs and takes the minimiser's step; stages follow one another. @p search
/// searches in @p target. Minimisers with equations need normals of the target, some also of the source
/// (MinimizerRow::sourceNormals); without them they end at once as Degenerate. The result does not depend on
/// the number of threads.
[[nodiscard]] IcpResult align(const PointCloud& target, const Search& search, const PointCloud& source,
                              const Pose& guess, const IcpSettings& settings = {},
                              const Progress& progress = {});

}  // namespace leitstand
