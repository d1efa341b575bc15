#include "core/robot/joints/joint_group.h"

#include <algorithm>
#include <limits>

namespace leitstand {

std::string toString(JointType type) {
    return type == JointType::Revolute ? "revolute" : "prismatic";
}

std::string toString(JointCommandMode mode) {
    return mode == JointCommandMode::Position ? "position" : "velocity";
}

double MovedJoint::within(double position) const {
    constexpr double Infinity = std::numeric_limits<double>::infinity();
    return std::clamp(position, lower.value_or(-Infinity), upper.value_or(Infinity));
}

std::optional<std::size_t> JointGroup::indexOf(const std::string& joint) const {
    const auto found =
        std::find_if(joints.begin(), joints.end(), [&](const MovedJoint& one) { return one.name == joint; });
    if (found == joints.end()) return std::nullopt;
    return static_cast<std::size_t>(found - joints.begin());
}

}  // namespace leitstand
