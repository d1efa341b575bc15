#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/services/domain/seen_topic.h"
#include "core/robot/robot_description.h"

namespace leitstand {

/// What a topic can be used for.
struct TopicVerdict {
    SeenTopic topic;
    std::optional<StreamRole> role;  ///< empty: the station does not use it
    std::string remark;              ///< why it has no role, or what the user should check; may be empty
};

/// A robot as far as its topics describe it.
struct RobotGuess {
    /// A first description. Footprint and height are those of its model, if that was received; else they, and
    /// all limits, are defaults of robot files.
    RobotDescription robot;
    std::vector<TopicVerdict> topics;
};

/// Assigns @p topics to the robots of robotSpaces() by their namespaces: "/kurt3d/odom" belongs to kurt3d.
/// Decides what each topic can be used for. Topics outside the robots' namespaces, for example those of
/// sensor drivers, belong to the robot without a namespace, which is called "robot". If there is none, they
/// belong to the only robot; if there are several, to none.
[[nodiscard]] std::vector<RobotGuess> guessRobots(const std::vector<SeenTopic>& topics);

}  // namespace leitstand
