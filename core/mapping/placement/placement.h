#pragma once

#include <cstdint>
#include <string>

#include "core/base/pose.h"
#include "core/mapping/live/map/local_map.h"
#include "core/mapping/placement/correlation.h"
#include "core/mapping/placement/laser_view.h"

namespace leitstand {

/// How a robot is placed in another one's map.
struct PlacementSettings {
    /// Where it starts, against the robot that makes the map: beside it, looking the same way.
    Pose slotInOther = poseFrom({0.0, -0.8, 0.0}, 0.0, 0.0, 0.0);
    SearchWindow slot;                          ///< about the slot ...
    SearchWindow dragged = {0.6, degrees(25)};  ///< ... and about where the operator put it
    double leastOverlap = 0.5;                  ///< of what the laser sees with the map ...
    double plentyOverlap = 0.8;                 ///< ... more makes it no surer
    double plentyContrast = 0.25;               ///< share by which the second best place is worse, likewise
    double plentyDirection = 0.12;              ///< WallFit::direction, likewise
    double leastCertainty = 0.3;                ///< below, the robot is not placed
    int leastPoints = 40;
};

/// Where a robot was found.
struct Placement {
    Pose baseInMap = Pose::Identity();  ///< the guess where it is not certain
    bool certain = false;
    double certainty = 0.0;  ///< 0 to 1
    double overlap = 0.0;    ///< share of what it sees that the map has
    std::string how;         ///< in words, with figures: why it is certain or not
};

/// Looks for a robot that sees @p view in @p local, within @p window about @p guess (base_link).
[[nodiscard]] Placement placeRobot(const LaserView& view, const LocalMap& local, const Pose& guess,
                                   const SearchWindow& window, const PlacementSettings& settings = {});

}  // namespace leitstand
