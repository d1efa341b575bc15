#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/cloud/scan.h"
#include "core/mapping/live/map/local_map.h"

namespace leitstand {

/// How the motion within a turn is estimated. The cost is bounded by the points and the iterations.
struct TurnRefinementSettings {
    bool on =
        false;  ///< of all turns: odometry with gyros tells the motion within a turn well enough, mostly
    double from = 0.015;  ///< a turn that fits so far from where odometry has it is looked at [m] ...
    double fromAngle = degrees(0.5);                           ///< ... or turned by so much [rad]
    int points = 1'500;                                        ///< of the turn that are looked at, at most
    int leastPairs = 200;                                      ///< of them that meet the map
    double spacing = 0.15;                                     ///< one point in each cube of this edge [m]
    double minRange = 0.4, maxRange = 15.0;                    ///< nearer and farther ones are left out [m]
    std::vector<double> maxDistances = {0.5, 0.3, 0.2, 0.15};  ///< of pairs, one an iteration [m]
    double outlier = 0.05;          ///< pairs farther apart count half, or less (Cauchy) [m]
    double hold = 2e-4;             ///< how strongly the drift is held at zero, per pair
    double leastCertainty = 0.003;  ///< information on the weakest direction, per pair; else nothing is told
    double leastGain = 0.1;         ///< by this share the squared distances have to get less
    double mostWay = 0.5;           ///< a drift that is larger is none [m] ...
    double mostTurned = degrees(15);  ///< ... [rad]
};

/// What the motion that was taken out of a turn is wrong by: a velocity that is constant over the turn, so
/// that the correction grows evenly from its first shot to its last one.
struct TurnDrift {
    using Twist = Eigen::Matrix<double, 6, 1>;  ///< translation first, scan's frame [m, rad]
    Twist middle = Twist::Zero();               ///< correction of what was seen halfway
    Twist whole = Twist::Zero();                ///< what it grows by over the turn

    /// The correction of what was seen when @p share (0 to 1) of the turn was over, in the scan's frame.
    [[nodiscard]] Pose at(double share) const;
};

/// Estimates the drift of the organised @p scan, which was registered to @p scanInMap, against @p local:
/// point to plane, with a constant velocity within the turn (as LOAM has it within a sweep, Zhang & Singh
/// 2014, and CT-ICP with a pose at either end of it, Dellenbach et al. 2022), held at zero as far as surfaces
/// do not tell. Rows are taken to follow each other evenly in time. Empty where the turn is better left as it
/// is: it does not lie in a grid, too few points meet the map, a direction is open, or it does not fit any
/// better.
[[nodiscard]] std::optional<TurnDrift> turnDrift(const Scan& scan, const LocalMap& local,
                                                 const Pose& scanInMap,
                                                 const TurnRefinementSettings& settings = {});

/// The organised @p scan with @p drift taken out of its points, as seen from the pose at its last shot, which
/// lies at drift.at(1) in the frame that it was registered with.
[[nodiscard]] Scan straightened(const Scan& scan, const TurnDrift& drift);

}  // namespace leitstand
