#pragma once

#include <string_view>

#include "core/robot/streams/stream_table.h"
#include "transport/dds/node.h"

namespace leitstand {

/// Returns the lane for samples of the ROS type @p type. Scans and pictures have their own lane, so that they
/// do not delay others.
[[nodiscard]] inline Lane laneOf(std::string_view type) {
    const bool large = isPictureType(type) || type == "sensor_msgs/msg/PointCloud2" ||
                       type == "livox_ros_driver2/msg/CustomMsg" || type == "leitstand_msgs/msg/KeyScan" ||
                       type.starts_with("visualization_msgs/") || type == "vision_msgs/msg/Detection3DArray";
    return large ? Lane::Large : Lane::Small;
}
[[nodiscard]] inline Flow flowOf(std::string_view type) {
    if (laneOf(type) == Lane::Small) return Flow::Telemetry;
    return isPictureType(type) ? Flow::Pictures : Flow::Scans;
}

}  // namespace leitstand
