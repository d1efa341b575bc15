#include "app/window/source/live_moment.h"

#include "core/mission/state/robot_state.h"

namespace leitstand {

const RobotView& LiveMoment::view(const std::string& robot) const {
    static const RobotView nothing;
    const auto found = robots.find(robot);
    return found == robots.end() ? nothing : found->second;
}

const RobotState& LiveMoment::reported(const std::string& robot) const {
    static const RobotState nothing;
    if (!mission) return nothing;
    const auto found = mission->robots.find(robot);
    return found == mission->robots.end() ? nothing : *found->second;
}

}  // namespace leitstand
