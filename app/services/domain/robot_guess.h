#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/robot/robot_description.h"

namespace leitstand {

/// A topic that was heard, or that a bag holds.
struct SeenTopic {
    std::string name;  ///< ROS name, or the DDS name where it is none
    std::string type;
    Qos qos;               ///< as offered (or asked for, when nobody writes)
    bool written = true;   ///< somebody publishes it
    bool read = false;     ///< somebody other than us subscribes it: commands
    std::string obstacle;  ///< why DDS keeps it from us ("its samples are told apart by keys"); may be empty
};

/// What a topic is good for.
struct TopicVerdict {
    SeenTopic topic;
    std::optional<StreamRole> role;  ///< empty: the station does nothing with it
    std::string remark;              ///< why not, or what to look at; may be empty
};

/// A robot as its topics tell.
struct RobotGuess {
    RobotDescription robot;  ///< a first description: sizes and limits are the robot files' defaults
    std::vector<TopicVerdict> topics;
};

/// Sorts @p topics to robots by namespace ("/kurt3d/odom" belongs to kurt3d) and tells what each is good for.
/// Topics outside any robot's namespace belong to the only robot, or to one called "robot".
[[nodiscard]] std::vector<RobotGuess> guessRobots(const std::vector<SeenTopic>& topics);

/// What @p topic carries; the reason why it is of no use in @p remark.
[[nodiscard]] std::optional<StreamRole> roleOf(const SeenTopic& topic, std::string& remark);

}  // namespace leitstand
