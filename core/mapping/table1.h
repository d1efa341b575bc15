#pragma once

#include <array>
#include <cstdint>

#include "core/base/pose.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/cloud/scan.h"
#include "core/cloud/search/search.h"

namespace leitstand {

/// Settings for measuring Table 1 of the paper again. All rows share everything but points and search.
struct Table1Settings {
    double maxDistance = 0.25;                ///< of pairs [m]
    double minRange = 0.48, maxRange = 25.0;  ///< of points [m]
    double epsilon = 0.5;                     ///< of the approximate searches
    double minStep = 1e-5;                    ///< the ICP ends when the pose moves less [m, rad]
    int maxIterations = 500;
    int bruteForceIterations = 1;  ///< really run; the time of the row is extrapolated from them
    int repetitions = 5;           ///< runs of each of the other rows; the median time counts
};

/// A row of Table 1: our figures, and those of the paper (Pentium IV, 3.2 GHz, an office).
struct Table1Row {
    bool reduced = false;  ///< points of the paper's median and reduction filter; else all in range
    SearchMethod search = SearchMethod::KdTree;
    std::size_t targetPoints = 0, sourcePoints = 0;
    double seconds = 0.0;  ///< building the search and all iterations, one thread [s]
    /// Whether `seconds` is the time of some iterations, extrapolated to as many as the all-points kd-tree
    /// row has.
    bool extrapolated = false;
    int iterations = 0;
    double speedUp = 1.0;                ///< seconds of the all-points kd-tree row over this row's
    double distance = 0.0, angle = 0.0;  ///< from the all-points kd-tree row's pose [m, rad]; of an
                                         ///< extrapolated row, from that row's pose after as many iterations
    bool counts = false;        ///< within CountDistance and CountAngle, and converged (unless extrapolated)
    double paperSeconds = 0.0;  ///< [s]; 0: "several hours"
    int paperIterations = 0;
    double paperSpeedUp = 0.0;  ///< 0: unknown

    static constexpr double CountDistance = 0.03;       ///< [m]
    static constexpr double CountAngle = degrees(0.5);  ///< [rad]
};

/// The five rows in the paper's order.
using Table1 = std::array<Table1Row, 5>;

/// Aligns @p source to @p target, both organised and labelled, starting from their odometry. It uses each of
/// the paper's five methods on one thread: point to point by singular value decomposition. Labelling and
/// reduction are not timed: the paper does them while scanning. Error when a scan has no points in range or
/// the work was cancelled.
[[nodiscard]] Result<Table1> measureTable1(const Scan& target, const Scan& source,
                                           const Table1Settings& settings = {},
                                           const Progress& progress = {});

}  // namespace leitstand
