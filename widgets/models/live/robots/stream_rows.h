#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/robot/robot_description.h"
#include "widgets/models/live/robots/stream_table.h"

namespace leitstand {

/// What is wished of a stream: by the operator, and with the thin link.
struct StreamSetting {
    StreamWish own, effective;
};

/// A row for each stream that @p robot sends, in the order of its file, after those that are in @p rows.
void appendStreamRows(std::vector<StreamRow>& rows, const RobotFace& face, const RobotDescription& robot,
                      const LinkStatus& link,
                      const std::function<StreamSetting(const std::string& topic)>& settings);

}  // namespace leitstand
