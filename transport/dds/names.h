#pragma once

#include <string>
#include <string_view>

namespace leitstand {

/// "/kurt3d/odom" -> "rt/kurt3d/odom". A name without a leading slash is no ROS name and is not changed, so
/// topics of other systems can be named, too.
[[nodiscard]] std::string ddsTopicOf(std::string_view rosTopic);
/// "rt/kurt3d/odom" -> "/kurt3d/odom"; any other name (also ROS services "rq/...") is not changed.
[[nodiscard]] std::string rosTopicOf(std::string_view ddsTopic);

/// Whether @p ddsTopic is a topic, service or action of ROS: its name begins with "rt/", "rq/" or "rr/".
[[nodiscard]] bool isRosTopic(std::string_view ddsTopic);

/// "nav_msgs/msg/Odometry" -> "nav_msgs::msg::dds_::Odometry_"; names of another form are not changed.
[[nodiscard]] std::string ddsTypeOf(std::string_view rosType);
/// "nav_msgs::msg::dds_::Odometry_" -> "nav_msgs/msg/Odometry"; names of another form are not changed.
[[nodiscard]] std::string rosTypeOf(std::string_view ddsType);

}  // namespace leitstand
