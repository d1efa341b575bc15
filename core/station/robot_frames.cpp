#include "core/station/robot_frames.h"

#include <cstddef>

#include "core/event/motion_samples.h"
#include "core/mapping/live/robot_in_map.h"
#include "core/mission/state/robot_state.h"

namespace leitstand {

std::optional<Pose> frameInMap(const std::string& frame, const RobotState& robot, const RobotInMap& place) {
    if (!place.placed || !robot.odometry) return std::nullopt;
    const OdometrySample& odometry = robot.odometry->sample;
    if (frame == odometry.childFrame) return place.baseInMap;
    Pose reachedInMap = place.odomInMap.value_or(place.baseInMap * odometry.baseInOdom.inverse());
    std::string reached = odometry.header.frame;
    for (std::size_t i = 0; i < RobotState::MostFramesAbove && reached != frame; ++i) {
        const auto above = robot.framesAbove.find(reached);
        if (above == robot.framesAbove.end()) return std::nullopt;
        reachedInMap = reachedInMap * above->second.inParent.inverse();
        reached = above->second.parent;
    }
    return reached == frame ? std::optional(reachedInMap) : std::nullopt;
}

}  // namespace leitstand
