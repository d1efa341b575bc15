#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/cloud/scan.h"
#include "core/mapping/live/map/local_map.h"

namespace leitstand {

/// Settings for estimating the motion within a turn. The numbers of points and iterations limit the time.
struct TurnRefinementSettings {
    /// Whether all turns are refined. Odometry with gyros usually measures the motion within a turn well
    /// enough.
    bool on = false;
    /// A turn is also refined if it fits farther than this from odometry's pose [m] ...
    double from = 0.015;
    double fromAngle = degrees(0.5);         ///< ... or turned by more than this [rad]
    int points = 1'500;                      ///< largest number of points of the turn that are used
    int leastPairs = 200;                    ///< least number of these points that must fit the map
    double spacing = 0.15;                   ///< only one point is used in each cube with this edge [m]
    double minRange = 0.4, maxRange = 15.0;  ///< nearer and farther points are left out [m]
    /// Largest distance of a pair, one per iteration [m].
    std::vector<double> maxDistances = {0.5, 0.3, 0.2, 0.15};
    double outlier = 0.05;  ///< pairs at this distance have half weight, farther ones less (Cauchy) [m]
    double hold = 2e-4;     ///< weight with which the drift is pulled to zero, per pair
    /// Least information on the weakest direction, per pair; below it there is no drift.
    double leastCertainty = 0.003;
    double leastGain = 0.1;           ///< least share by which the squared distances must decrease
    double mostWay = 0.5;             ///< larger drift is rejected [m] ...
    double mostTurned = degrees(15);  ///< ... and a larger turn [rad]
};

/// The error of the motion that was removed from a turn, as a velocity that is constant over the turn. The
/// correction grows evenly from the first shot to the last.
struct TurnDrift {
    using Twist = Eigen::Matrix<double, 6, 1>;  ///< translation, then rotation, in the scan's frame [m, rad]
    Twist middle = Twist::Zero();               ///< correction of points seen in the middle of the turn
    Twist whole = Twist::Zero();                ///< growth of the correction over the whole turn

    /// Returns the correction of points seen after @p share (0 to 1) of the turn, in the scan's frame.
    [[nodiscard]] Pose at(double share) const;
};

/// Estimates the drift of the organised @p scan, which was registered to @p scanInMap, against @p local:
/// point to plane, with a constant velocity within the turn. LOAM makes this assumption within a sweep (Zhang
/// & Singh 2014); CT-ICP has a pose at each end (Dellenbach et al. 2022). The drift is pulled to zero where
/// surfaces do not determine it. The rows of @p scan must be evenly spaced in time. Empty if the turn should
/// stay as it is: it has no grid, too few points fit the map, a direction is open, or it does not fit better.
[[nodiscard]] std::optional<TurnDrift> turnDrift(const Scan& scan, const LocalMap& local,
                                                 const Pose& scanInMap,
                                                 const TurnRefinementSettings& settings = {});

/// Returns the organised @p scan with @p drift removed, as seen from the pose at its last shot. That pose is
/// drift.at(1) in the frame in which the scan was registered.
[[nodiscard]] Scan straightened(const Scan& scan, const TurnDrift& drift);

}  // namespace leitstand
