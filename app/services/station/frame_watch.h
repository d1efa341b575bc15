#pragma once

#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "app/services/log/event_sink.h"
#include "core/robot/robot_description.h"
#include "core/station/frames/frame_tree.h"

namespace leitstand {

/// The tf trees of the station's robots, as they are now. Any thread.
class FrameWatch final : public EventSink {
public:
    void onEvent(const Event& event) override;

    /// Returns the frames of @p robot, each below its parent; empty: no transforms came.
    [[nodiscard]] std::vector<FrameRow> rows(const std::string& robot) const;
    /// Returns the frames of sensors in the file of @p robot to which no transforms lead from its base.
    [[nodiscard]] std::vector<std::string> unconnected(const RobotDescription& robot) const;

private:
    mutable std::mutex m_mutex;
    std::map<std::string, FrameTree> m_trees;  ///< by robot
};

}  // namespace leitstand
