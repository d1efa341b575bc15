#include "widgets/models/map/robots/robot_plans.h"

#include <algorithm>
#include <utility>

#include "core/event/motion_samples.h"
#include "core/mapping/live/robot_in_map.h"
#include "core/station/robot_frames.h"
#include "widgets/models/map/robots/drawn_alike.h"

namespace leitstand {

std::shared_ptr<const PlannedPaths> RobotPlans::at(const RobotState& robot, const RobotInMap& place,
                                                   Time now) {
    std::vector<Drawn> drawn;
    for (const auto& [topic, path] : robot.paths) {
        if (!path || path->sample.posesInFrame.empty() || now - path->received > Lasts) continue;
        const auto frame = frameInMap(path->sample.header.frame, robot, place);
        if (!frame) continue;
        const Eigen::Vector3d end = *frame * path->sample.posesInFrame.back().translation();
        if ((end - place.baseInMap.translation()).head<2>().norm() < AtItsEnd) continue;
        drawn.push_back({path, *frame});
    }
    const bool same = std::equal(drawn.begin(), drawn.end(), m_drawn.begin(), m_drawn.end(),
                                 [](const Drawn& a, const Drawn& b) {
                                     return a.path == b.path && drawnAlike(a.frameInMap, b.frameInMap);
                                 });
    if (same) return m_paths;
    auto paths = std::make_shared<PlannedPaths>();
    for (const Drawn& one : drawn) {
        std::vector<Eigen::Vector3d>& line = paths->emplace_back();
        for (const Pose& pose : one.path->sample.posesInFrame)
            line.emplace_back(one.frameInMap * pose.translation());
    }
    m_drawn = std::move(drawn);
    m_paths = m_drawn.empty() ? nullptr : std::move(paths);
    return m_paths;
}

}  // namespace leitstand
