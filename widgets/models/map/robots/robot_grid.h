#pragma once

#include <optional>
#include <string>

#include <QString>

#include "core/base/pose.h"
#include "core/mission/state/robot_state.h"

namespace leitstand {

struct RobotInMap;

/// A grid map or costmap of a robot's own, as it is drawn over the map.
struct RobotGrid {
    LatestPtr<OccupancyGridSample> grid;  ///< never null
    /// Pose in the map of the outer corner of cell (0, 0), x and y along the grid's edges.
    Pose gridInMap = Pose::Identity();
    int robotPlace = 0;  ///< place of the robot in the team, which gives the colour
    QString title;       ///< "TurtleBot 4: /map"
};

/// Returns the robot's grid on @p topic; empty: it sent none, or no tf leads from its odometry to the grid's
/// frame. Title and colour are the caller's.
[[nodiscard]] std::optional<RobotGrid> robotGridOf(const std::string& topic, const RobotState& robot,
                                                   const RobotInMap& place);

/// Whether @p a and @p b look the same (drawnAlike()).
[[nodiscard]] bool sameGrid(const RobotGrid& a, const RobotGrid& b);

/// Returns the topic of a grid of @p robot that is shown after @p topic (empty: none is shown); empty: none
/// is shown then.
[[nodiscard]] std::string gridAfter(const std::string& topic, const RobotState& robot);

}  // namespace leitstand
