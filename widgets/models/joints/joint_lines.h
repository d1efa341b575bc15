#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/robot/robot_description.h"

namespace leitstand {

/// A link of a joint, seen from the robot's right: x ahead, z up, in the base frame [m].
struct JointLine {
    Eigen::Vector2d from = Eigen::Vector2d::Zero(), to = Eigen::Vector2d::Zero();
    bool chosen = false;  ///< whether the controls move it
};

/// Returns the links of @p group at @p positions, one for each joint. Links with an unknown position (empty),
/// and those that hang on them, are left out. @p axis: the axis that the controls move; empty: none of this
/// group.
[[nodiscard]] std::vector<JointLine> jointLines(const JointGroup& group,
                                                const std::vector<std::optional<double>>& positions,
                                                std::optional<std::size_t> axis);

/// A box in the same view: a robot's body without flippers and arm.
struct SideView {
    Eigen::Vector2d low = Eigen::Vector2d::Zero(), high = Eigen::Vector2d::Zero();
};
[[nodiscard]] SideView bodyFromTheSide(const RobotDescription& robot);
/// Returns the box around the body of @p robot, all that its flippers can reach, and @p lines. A chain of
/// links, as an arm, only counts as it is, since its reach is far larger than the robot.
[[nodiscard]] SideView reachFromTheSide(const RobotDescription& robot, const std::vector<JointLine>& lines);

}  // namespace leitstand
