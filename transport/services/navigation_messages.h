#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/event/motion_samples.h"
#include "core/event/raw_event.h"
#include "core/robot/services/goal_tracker.h"

namespace leitstand {

/// Names of the topics and services of an action (design.ros2.org, "Actions").
struct ActionNames {
    std::string sendGoal, cancelGoal;  ///< services, "/navigate_to_pose/_action/send_goal"
    std::string feedback, status;      ///< topics, "/navigate_to_pose/_action/feedback"
    std::string sendGoalType, feedbackType;
};
/// @p name: ROS name, "/navigate_to_pose"; @p type: ROS name, "nav2_msgs/action/NavigateToPose".
[[nodiscard]] ActionNames actionNames(const std::string& name, const std::string& type);

inline constexpr const char* NavigateToPose = "nav2_msgs/action/NavigateToPose";
inline constexpr const char* CancelGoalType = "action_msgs/srv/CancelGoal";
inline constexpr const char* GoalStatusType = "action_msgs/msg/GoalStatusArray";

/// The request of a goal of NavigateToPose; behaviour tree: the robot's usual one.
struct NavigationGoal {
    GoalId id{};
    PoseSample goal;
};
/// Error: a frame that is not printable, or a pose that is no pose.
[[nodiscard]] Result<Payload> encodeGoal(const NavigationGoal& goal);
[[nodiscard]] Result<NavigationGoal> decodeGoal(std::span<const std::byte> bytes);
/// The answer to it.
[[nodiscard]] Payload encodeAcceptance(bool accepted);
[[nodiscard]] Result<bool> decodeAcceptance(std::span<const std::byte> bytes);

/// The request to give up one goal of an action (action_msgs/srv/CancelGoal).
[[nodiscard]] Payload encodeCancel(const GoalId& goal);
[[nodiscard]] Result<GoalId> decodeCancel(std::span<const std::byte> bytes);

/// What is left of the way to a goal of NavigateToPose (its feedback in Nav2 of Galactic and later).
struct NavigationProgress {
    GoalId id{};
    double seconds = 0.0;  ///< estimated time [s]
    int recoveries = 0;
    double metres = 0.0;  ///< [m]
};
[[nodiscard]] Payload encodeProgress(const NavigationProgress& progress);
[[nodiscard]] Result<NavigationProgress> decodeProgress(std::span<const std::byte> bytes);

/// States of an action's goals (action_msgs/msg/GoalStatusArray).
[[nodiscard]] Payload encodeStatus(std::span<const GoalTracker::Report> goals);
[[nodiscard]] Result<std::vector<GoalTracker::Report>> decodeStatus(std::span<const std::byte> bytes);

}  // namespace leitstand
