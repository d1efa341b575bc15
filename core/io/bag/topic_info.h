#pragma once

#include <string>

#include "core/robot/streams/qos.h"

namespace leitstand {

/// A topic as a rosbag2 bag describes it.
struct TopicInfo {
    std::string name{};                 ///< ROS name, "/kurt3d/odom"
    std::string type{};                 ///< "nav_msgs/msg/Odometry"
    std::string qosProfiles{};          ///< YAML as rosbag2 writes it; see qosProfilesOf(); may be empty
    std::string definition{};           ///< the ROS .msg text with all it depends on; may be empty
    std::string typeHash{};             ///< "RIHS01_..."; may be empty
    bool droppable = false;             ///< pictures: the first that a slow disk costs; not stored in the bag
    bool urgent = false;                ///< acts of people: committed at once; not stored in the bag
    std::string serialization = "cdr";  ///< serialization_format
    friend bool operator==(const TopicInfo&, const TopicInfo&) = default;
};

/// @p qos as rosbag2 stores the profiles that a topic was offered with (a YAML list of one).
[[nodiscard]] std::string qosProfilesOf(const Qos& qos);

}  // namespace leitstand
