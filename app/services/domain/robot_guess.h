#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/robot/robot_description.h"

namespace leitstand {

/// A topic that was received, or that a bag holds.
struct SeenTopic {
    std::string name;  ///< ROS name, or the DDS name if it has none
    std::string type;
    Qos qos;               ///< as offered (or asked for, when nobody writes)
    bool written = true;   ///< somebody publishes it
    bool read = false;     ///< somebody other than us subscribes to it: commands
    std::string obstacle;  ///< why DDS keeps its samples from us; may be empty
    /// Whole names of the nodes of ROS 2 that publish it, or read it when nobody does: "/kurt3d/driver".
    /// Empty: unknown.
    std::vector<std::string> nodes = {};
};

/// What a topic is good for.
struct TopicVerdict {
    SeenTopic topic;
    std::optional<StreamRole> role;  ///< empty: the station does nothing with it
    std::string remark;              ///< why not, or what to check; may be empty
};

/// A robot as its topics describe it.
struct RobotGuess {
    RobotDescription robot;  ///< a first description: sizes and limits are the robot files' defaults
    std::vector<TopicVerdict> topics;
};

/// Assigns @p topics to the robots of robotSpaces() ("/kurt3d/odom" belongs to kurt3d) and rates what each is
/// good for. Topics of no robot's namespace, as of the drivers of sensors, belong to the robot without one,
/// which is called "robot", or to the only one.
[[nodiscard]] std::vector<RobotGuess> guessRobots(const std::vector<SeenTopic>& topics);

/// Returns what @p topic carries; sets @p remark to why it is of no use, or what to check.
[[nodiscard]] std::optional<StreamRole> roleOf(const SeenTopic& topic, std::string& remark);

}  // namespace leitstand
