#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/robot/robot_description.h"
#include "widgets/models/live/robots/stream_table.h"

namespace leitstand {

/// The wishes for a stream: the operator's own, and those in effect with a thin link.
struct StreamSetting {
    StreamRequest own, effective;
};

/// Appends a row to @p rows for each stream that @p robot sends, in the order of its file.
void appendStreamRows(std::vector<StreamRow>& rows, const RobotFace& face, const RobotDescription& robot,
                      const LinkStatus& link,
                      const std::function<StreamSetting(const std::string& topic)>& settings);

}  // namespace leitstand
