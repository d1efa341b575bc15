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
    Qos qos;               ///< as offered (or requested, when nobody writes)
    bool written = true;   ///< somebody publishes it
    bool read = false;     ///< somebody other than us subscribes to it, as robots do to commands
    std::string obstacle;  ///< why DDS cannot deliver its samples to us; empty: it can
    /// Full names of the ROS 2 nodes that publish the topic, or that read it when nobody publishes:
    /// "/kurt3d/driver". Empty: unknown.
    std::vector<std::string> nodes = {};
};

/// What a topic is good for.
struct TopicVerdict {
    SeenTopic topic;
    std::optional<StreamRole> role;  ///< empty: the station does nothing with it
    std::string remark;              ///< why it has no role, or what to check; may be empty
};

/// A robot as its topics describe it.
struct RobotGuess {
    RobotDescription robot;  ///< a first description: sizes and limits are the robot files' defaults
    std::vector<TopicVerdict> topics;
};

/// Assigns @p topics to the robots of robotSpaces() by their namespaces: "/kurt3d/odom" belongs to kurt3d.
/// Judges what each topic is good for. Topics outside the robots' namespaces, for example those of sensor
/// drivers, belong to the robot without a namespace, which is called "robot". Without such a robot they
/// belong to the only robot; among several, to none.
[[nodiscard]] std::vector<RobotGuess> guessRobots(const std::vector<SeenTopic>& topics);

/// Returns the role of @p topic; empty: the station has no use for it. Sets @p remark to the reason, or to
/// what the user should check.
[[nodiscard]] std::optional<StreamRole> roleOf(const SeenTopic& topic, std::string& remark);

}  // namespace leitstand
