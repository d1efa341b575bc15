#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/robot/robot_description.h"
#include "widgets/models/live/robots/stream_table.h"

namespace leitstand {

/// The requests for a stream: the operator's own, and the one in effect, which a thin link may limit.
struct StreamSetting {
    StreamRequest own, effective;
};

/// Appends a row to @p rows for each stream that @p robot sends, in the order of the robot's file.
/// @p mapsWith: topic of the clouds that make the map, if the robot has several. @p settings: returns the
/// requests for a topic.
void appendStreamRows(std::vector<StreamRow>& rows, const RobotFace& face, const RobotDescription& robot,
                      const LinkStatus& link, const std::string& mapsWith,
                      const std::function<StreamSetting(const std::string& topic)>& settings);

}  // namespace leitstand
