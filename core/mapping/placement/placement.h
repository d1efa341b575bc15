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
    /// Start of the robot relative to that of the robot that makes the map: beside it, with the same heading.
    Pose slotInOther = poseFrom({0.0, -0.8, 0.0}, 0.0, 0.0, 0.0);
    SearchWindow slot;                          ///< around the slot ...
    SearchWindow dragged = {0.6, degrees(25)};  ///< ... and around where the operator put it
    double leastOverlap = 0.5;                  ///< least share of what the laser sees that is in the map ...
    double plentyOverlap = 0.8;                 ///< ... and share beyond which the certainty does not rise
    double plentyContrast = 0.25;   ///< share that the second best lacks; beyond, the certainty does not rise
    double plentyDirection = 0.12;  ///< WallFit::direction beyond which the certainty does not rise
    double leastCertainty = 0.3;    ///< below, the robot is not placed
    int leastPoints = 40;
};

/// The result of placing a robot.
struct Placement {
    Pose baseInMap = Pose::Identity();  ///< the guess where it is not certain
    bool certain = false;
    double certainty = 0.0;  ///< 0 to 1
    double overlap = 0.0;    ///< share of the view that the map has
    std::string how;         ///< in words, with figures: why it is certain or not
};

/// Looks in @p local for a robot that sees @p view, within @p window around @p guess (base_link).
[[nodiscard]] Placement placeRobot(const LaserView& view, const LocalMap& local, const Pose& guess,
                                   const SearchWindow& window, const PlacementSettings& settings = {});

}  // namespace leitstand
