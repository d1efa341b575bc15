#include "core/robot/joints/joint_message.h"

#include <chrono>
#include <utility>
#include <vector>

#include "core/event/motion_samples.h"

namespace leitstand {
namespace {

constexpr std::chrono::milliseconds Ahead(100);

std::vector<std::string> namesOf(const JointGroup& group) {
    std::vector<std::string> names;
    for (const MovedJoint& joint : group.joints) names.push_back(joint.name);
    return names;
}

}  // namespace

Sample jointMessage(const JointGroup& group, const JointSetpoints& setpoints, const std::string& type) {
    if (type == "std_msgs/msg/Float64MultiArray") return NumbersSample{setpoints.values};
    const bool velocities = setpoints.mode == JointCommandMode::Velocity;
    if (type == "sensor_msgs/msg/JointState") {
        JointSample command;
        command.names = namesOf(group);
        (velocities ? command.velocities : command.positions) = setpoints.values;
        return command;
    }
    JointTrajectorySample command;
    command.names = namesOf(group);
    TrajectoryPoint point;
    (velocities ? point.velocities : point.positions) = setpoints.values;
    point.fromStart = Ahead;
    command.points.push_back(std::move(point));
    return command;
}

}  // namespace leitstand
