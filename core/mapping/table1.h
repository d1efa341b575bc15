#pragma once

#include <array>
#include <cstdint>

#include "core/base/pose.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/cloud/scan.h"
#include "core/cloud/search/search.h"

namespace leitstand {

/// Settings for measuring Table 1 of the paper again. Rows differ only in points and search.
struct Table1Settings {
    double maxDistance = 0.25;                ///< largest distance of a pair [m]
    double minRange = 0.48, maxRange = 25.0;  ///< nearer and farther points are left out [m]
    double epsilon = 0.5;                     ///< epsilon of the approximate searches
    double minStep = 1e-5;                    ///< the ICP ends when the pose moves less than this [m, rad]
    int maxIterations = 500;
    /// Iterations of brute force that are run; the time of its row is extrapolated from them.
    int bruteForceIterations = 1;
    int repetitions = 5;  ///< runs of each other row; their median time is used
};

/// A row of Table 1: our figures, and those of the paper (Pentium IV, 3.2 GHz, an office).
struct Table1Row {
    /// Whether the points come from the paper's median and reduction filter; if not, all in range.
    bool reduced = false;
    SearchMethod search = SearchMethod::KdTree;
    std::size_t targetPoints = 0, sourcePoints = 0;
    double seconds = 0.0;  ///< time for building the search and for all iterations, one thread [s]
    /// Whether `seconds` is extrapolated: from the time of some iterations to as many as the all-points
    /// kd-tree row has.
    bool extrapolated = false;
    int iterations = 0;
    double speedUp = 1.0;  ///< seconds of the all-points kd-tree row divided by those of this row
    /// Difference from the pose of the all-points kd-tree row [m, rad]; for an extrapolated row, from that
    /// row's pose after as many iterations.
    double distance = 0.0, angle = 0.0;
    /// The differences are within CountDistance and CountAngle, and it converged (unless extrapolated).
    bool counts = false;
    double paperSeconds = 0.0;  ///< time in the paper [s]; 0: "several hours"
    int paperIterations = 0;
    double paperSpeedUp = 0.0;  ///< speed-up in the paper; 0: unknown

    static constexpr double CountDistance = 0.03;       ///< largest `distance` of a row that counts [m]
    static constexpr double CountAngle = degrees(0.5);  ///< largest `angle` of a row that counts [rad]
};

/// The five rows in the paper's order.
using Table1 = std::array<Table1Row, 5>;

/// Aligns @p source to @p target, both organised and labelled, starting from their odometry. Each of the
/// paper's five methods is run on one thread, point to point by singular value decomposition. Labelling and
/// reduction are not timed, since the paper does them while scanning. Error: a scan has no points in range,
/// or the work was cancelled.
[[nodiscard]] Result<Table1> measureTable1(const Scan& target, const Scan& source,
                                           const Table1Settings& settings = {},
                                           const Progress& progress = {});

}  // namespace leitstand
