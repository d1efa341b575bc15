#pragma once

#include <span>
#include <string_view>

namespace leitstand {

/// A message type that Leitstand knows.
struct MessageType {
    std::string_view rosName;     ///< "nav_msgs/msg/Odometry"
    std::string_view ddsName;     ///< "nav_msgs::msg::dds_::Odometry_"
    std::string_view hash;        ///< "RIHS01_..." (REP 2016)
    std::string_view definition;  ///< text in rosbag2's encoding "ros2msg", including all types that it uses
};

/// Returns all types, sorted by ROS name.
[[nodiscard]] std::span<const MessageType> messageTypes();

/// Returns the type with this ROS or DDS name; null when it is unknown.
[[nodiscard]] const MessageType* findMessageType(std::string_view rosOrDdsName);

}  // namespace leitstand
