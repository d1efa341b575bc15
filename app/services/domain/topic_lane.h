#pragma once

#include <string_view>

#include "transport/dds/node.h"

namespace leitstand {

/// Returns the lane for samples of the ROS type @p type. Scans and pictures have their own lane, so that they
/// do not delay others.
[[nodiscard]] inline Lane laneOf(std::string_view type) {
    const bool large = type == "sensor_msgs/msg/PointCloud2" || type == "sensor_msgs/msg/Image" ||
                       type == "sensor_msgs/msg/CompressedImage" || type == "leitstand_msgs/msg/KeyScan";
    return large ? Lane::Large : Lane::Small;
}
[[nodiscard]] inline Flow flowOf(std::string_view type) {
    if (laneOf(type) == Lane::Small) return Flow::Telemetry;
    return type.ends_with("Image") ? Flow::Pictures : Flow::Scans;
}

}  // namespace leitstand
