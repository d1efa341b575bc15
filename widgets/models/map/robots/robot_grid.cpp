#include "widgets/models/map/robots/robot_grid.h"

#include "core/event/map_samples.h"
#include "core/mapping/live/robot_in_map.h"
#include "core/station/robot_frames.h"
#include "widgets/models/map/robots/drawn_alike.h"

namespace leitstand {

std::optional<RobotGrid> robotGridOf(const std::string& topic, const RobotState& robot,
                                     const RobotInMap& place) {
    const auto found = robot.grids.find(topic);
    if (found == robot.grids.end() || !found->second) return std::nullopt;
    const OccupancyGridSample& grid = found->second->sample;
    const auto frame = frameInMap(grid.header.frame, robot, place);
    if (!frame) return std::nullopt;
    return RobotGrid{.grid = found->second, .gridInMap = *frame * grid.gridInFrame, .title = {}};
}

bool sameGrid(const RobotGrid& a, const RobotGrid& b) {
    return a.grid == b.grid && a.robotPlace == b.robotPlace && a.title == b.title &&
           drawnAlike(a.gridInMap, b.gridInMap);
}

std::string gridAfter(const std::string& topic, const RobotState& robot) {
    const auto next = topic.empty() ? robot.grids.begin() : robot.grids.upper_bound(topic);
    return next == robot.grids.end() ? std::string() : next->first;
}

}  // namespace leitstand
