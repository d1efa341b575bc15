#include "app/services/station/frame_watch.h"

#include <algorithm>

#include "app/services/log/sequencer.h"
#include "core/event/event.h"
#include "core/event/motion_samples.h"
#include "core/robot/frame_names.h"

namespace leitstand {

void FrameWatch::onEvent(const Event& event) {
    if (event.robot.empty() || !event.sample.is<TransformsSample>()) return;
    const std::lock_guard lock(m_mutex);
    m_trees[event.robot].take(event);
}

std::vector<FrameRow> FrameWatch::rows(const std::string& robot) const {
    const std::lock_guard lock(m_mutex);
    const auto tree = m_trees.find(robot);
    return tree == m_trees.end() ? std::vector<FrameRow>() : tree->second.rows(stationTime());
}

std::vector<std::string> FrameWatch::unconnected(const RobotDescription& robot) const {
    const std::lock_guard lock(m_mutex);
    const auto tree = m_trees.find(robot.name);
    std::vector<std::string> frames;
    for (const auto& [name, sensor] : robot.sensors) {
        const std::string frame = frameName(robot, sensor.frame);
        const bool leads =
            tree != m_trees.end() && tree->second.connects(frameName(robot, robot.baseFrame), frame);
        if (!leads && std::find(frames.begin(), frames.end(), frame) == frames.end()) frames.push_back(frame);
    }
    return frames;
}

}  // namespace leitstand
