#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/robot/robot_description.h"

namespace leitstand {

/// A topic that was received, or that is in a bag.
struct SeenTopic {
    std::string name;  ///< ROS name; the DDS name if it has no ROS name
    std::string type;
    Qos qos;               ///< as offered, or as requested if nobody writes
    bool written = true;   ///< somebody publishes it
    bool read = false;     ///< somebody other than this station subscribes to it, as robots do to commands
    std::string obstacle;  ///< why DDS cannot deliver its samples to this station; empty: it can
    /// Full names of the ROS 2 nodes that publish the topic, or that read it if nobody publishes:
    /// "/kurt3d/driver". Empty: unknown.
    std::vector<std::string> nodes = {};
};

/// What a topic can be used for.
struct TopicVerdict {
    SeenTopic topic;
    std::optional<StreamRole> role;  ///< empty: the station does not use it
    std::string remark;              ///< why it has no role, or what the user should check; may be empty
};

/// A robot as far as its topics describe it.
struct RobotGuess {
    RobotDescription robot;  ///< a first description; sizes and limits are defaults of robot files
    std::vector<TopicVerdict> topics;
};

/// Assigns @p topics to the robots of robotSpaces() by their namespaces: "/kurt3d/odom" belongs to kurt3d.
/// Decides what each topic can be used for. Topics outside the robots' namespaces, for example those of
/// sensor drivers, belong to the robot without a namespace, which is called "robot". If there is none, they
/// belong to the only robot; if there are several, to none.
[[nodiscard]] std::vector<RobotGuess> guessRobots(const std::vector<SeenTopic>& topics);

/// Returns the role of @p topic; empty: the station does not use it. Sets @p remark to the reason, or to what
/// the user should check.
[[nodiscard]] std::optional<StreamRole> roleOf(const SeenTopic& topic, std::string& remark);

}  // namespace leitstand
