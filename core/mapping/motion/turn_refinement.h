#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/cloud/scan.h"
#include "core/mapping/live/map/local_map.h"

namespace leitstand {

/// Settings of the estimate of the motion within a turn. Points and iterations bound its cost.
struct TurnRefinementSettings {
    /// Refines all turns. Odometry with gyros mostly measures the motion within a turn well enough.
    bool on = false;
    double from = 0.015;  ///< a turn is also refined if it fits so far from odometry's pose [m] ...
    double fromAngle = degrees(0.5);         ///< ... or turned by so much [rad]
    int points = 1'500;                      ///< largest number of points of the turn that are used
    int leastPairs = 200;                    ///< least number of these points that meet the map
    double spacing = 0.15;                   ///< one point in each cube of this edge [m]
    double minRange = 0.4, maxRange = 15.0;  ///< nearer and farther points are left out [m]
    std::vector<double> maxDistances = {0.5, 0.3, 0.2, 0.15};  ///< largest of pairs, one per iteration [m]
    double outlier = 0.05;            ///< pairs farther apart count half, or less (Cauchy) [m]
    double hold = 2e-4;               ///< how strongly the drift is held at zero, per pair
    double leastCertainty = 0.003;    ///< least information on the weakest direction, per pair; else no drift
    double leastGain = 0.1;           ///< least share by which the squared distances fall
    double mostWay = 0.5;             ///< a larger drift is rejected [m] ...
    double mostTurned = degrees(15);  ///< ... [rad]
};

/// The error of the motion that was taken out of a turn: a velocity that is constant over the turn. The
/// correction grows evenly from the first shot to the last one.
struct TurnDrift {
    using Twist = Eigen::Matrix<double, 6, 1>;  ///< translation first, scan's frame [m, rad]
    Twist middle = Twist::Zero();               ///< correction of points seen halfway
    Twist whole = Twist::Zero();                ///< its growth over the turn

    /// Returns the correction of points seen when @p share (0 to 1) of the turn was over, in the scan's
    /// frame.
    [[nodiscard]] Pose at(double share) const;
};

/// Estimates the drift of the organised @p scan, which was registered to @p scanInMap, against @p local:
/// point to plane, with a constant velocity within the turn. LOAM assumes this within a sweep (Zhang & Singh
/// 2014), and CT-ICP has a pose at either end of it (Dellenbach et al. 2022). The drift is held at zero where
/// surfaces do not constrain it. The rows of @p scan must follow each other evenly in time. Empty if the turn
/// is better left as it is: it is no grid, too few points meet the map, a direction is open, or it fits no
/// better.
[[nodiscard]] std::optional<TurnDrift> turnDrift(const Scan& scan, const LocalMap& local,
                                                 const Pose& scanInMap,
                                                 const TurnRefinementSettings& settings = {});

/// Returns the organised @p scan with @p drift taken out of its points, as seen from the pose at its last
/// shot. That pose is drift.at(1) in the frame that the scan was registered with.
[[nodiscard]] Scan straightened(const Scan& scan, const TurnDrift& drift);

}  // namespace leitstand
