#include "widgets/models/live/robots/stream_rows.h"

#include <algorithm>

#include "core/event/stream_role.h"
#include "core/robot/streams/stream_table.h"
#include "widgets/models/others_text.h"

namespace leitstand {
namespace {

/// "sensor_msgs/msg/PointCloud2" -> "PointCloud2"
QString shortType(const std::string& type) {
    return othersText(type.substr(type.rfind('/') + 1));
}

/// Whether a slower or coarser stream would still be useful and the robot can provide it.
bool isSettable(const RobotDescription& robot, StreamRole role) {
    return streamFacts(role).steady && role != StreamRole::Diagnostics &&
           robot.stream(StreamRole::StreamCommand) != nullptr;
}

}  // namespace

void appendStreamRows(std::vector<StreamRow>& rows, const RobotFace& face, const RobotDescription& robot,
                      const LinkStatus& link, const std::string& mapsWith,
                      const std::function<StreamSetting(const std::string& topic)>& settings) {
    const auto scanners = std::count_if(robot.streams.begin(), robot.streams.end(),
                                        [&](const StreamDescription& one) { return robot.mayMap(one); });
    const bool choice = scanners > 1 && robot.stream(StreamRole::Points) != nullptr;
    for (const StreamStatus& stream : link.streams) {
        const auto described =
            std::find_if(robot.streams.begin(), robot.streams.end(),
                         [&](const StreamDescription& one) { return one.topic == stream.topic; });
        if (described == robot.streams.end()) continue;
        const StreamSetting setting = settings(stream.topic);
        rows.push_back({.face = face,
                        .stream = stream,
                        .type = shortType(described->type),
                        .own = setting.own,
                        .effective = setting.effective,
                        .settable = isSettable(robot, stream.role),
                        .mayMap = choice && robot.mayMap(*described),
                        .maps = choice && stream.topic == mapsWith});
    }
}

}  // namespace leitstand
