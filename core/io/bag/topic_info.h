#pragma once

#include <string>

#include "core/robot/streams/qos.h"

namespace leitstand {

/// A topic as a rosbag2 bag describes it.
struct TopicInfo {
    std::string name{};         ///< ROS name, "/kurt3d/odom"
    std::string type{};         ///< "nav_msgs/msg/Odometry"
    std::string qosProfiles{};  ///< YAML as rosbag2 writes it; see qosProfilesOf(); may be empty
    std::string definition{};   ///< the ROS .msg text with its dependencies; may be empty
    std::string typeHash{};     ///< "RIHS01_..."; may be empty
    bool droppable = false;     ///< of pictures: dropped first when the disk is slow; not stored in the bag
    bool urgent = false;        ///< of operators' actions: committed at once; not stored in the bag
    std::string serialization = "cdr";  ///< serialization_format
    friend bool operator==(const TopicInfo&, const TopicInfo&) = default;
};

/// Returns @p qos as rosbag2 stores the offered profiles of a topic (a YAML list of one).
[[nodiscard]] std::string qosProfilesOf(const Qos& qos);

}  // namespace leitstand
