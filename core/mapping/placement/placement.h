#pragma once

#include <cstdint>
#include <string>

#include "core/base/pose.h"
#include "core/mapping/live/map/local_map.h"
#include "core/mapping/placement/correlation.h"
#include "core/mapping/placement/laser_view.h"

namespace leitstand {

/// Settings for placing a robot in another robot's map.
struct PlacementSettings {
    /// Where the robot starts relative to the robot that makes the map: beside it, with the same heading.
    Pose slotInOther = poseFrom({0.0, -0.8, 0.0}, 0.0, 0.0, 0.0);
    SearchWindow slot;                          ///< search around the slot ...
    SearchWindow dragged = {0.6, degrees(25)};  ///< ... and around the place that the operator chose
    double leastOverlap = 0.5;                  ///< least share of the view that must fit the map ...
    double plentyOverlap = 0.8;                 ///< ... and the share above which certainty does not rise
    /// Lead over the second-best place above which certainty does not rise, as a share.
    double plentyContrast = 0.25;
    double plentyDirection = 0.12;  ///< WallFit::direction above which certainty does not rise
    double leastCertainty = 0.3;    ///< least certainty at which the robot is placed
    int leastPoints = 40;
};

/// The result of placing a robot.
struct Placement {
    Pose baseInMap = Pose::Identity();  ///< the guess if it is not certain
    bool certain = false;
    double certainty = 0.0;  ///< certainty of the pose, 0 to 1
    double overlap = 0.0;    ///< share of the view that fits the map
    std::string how;         ///< English text with figures: why the pose is certain or not
};

/// Looks in @p local for a robot whose laser sees @p view, within @p window around @p guess (base_link).
[[nodiscard]] Placement placeRobot(const LaserView& view, const LocalMap& local, const Pose& guess,
                                   const SearchWindow& window, const PlacementSettings& settings = {});

}  // namespace leitstand
