#include "core/robot/model/robot_model.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

namespace leitstand {
namespace {

constexpr double Infinite = std::numeric_limits<double>::infinity();

std::string_view withoutPrefix(std::string_view frame) {
    return frame.substr(frame.rfind('/') + 1);
}

double atRest(const ModelJoint& joint) {
    return std::max(joint.lower.value_or(-Infinite), std::min(joint.upper.value_or(Infinite), 0.0));
}

double positionOf(const ModelJoint& joint, const JointPositions& positions) {
    // Some drivers send NaN for what they do not know; huge numbers are no angles.
    constexpr double Most = 1e5;  // [rad or m]
    const auto isSane = [](double position) { return std::abs(position) <= Most; };
    if (const auto own = positions(joint.name); own && isSane(*own)) return *own;
    if (joint.mimics) {
        const auto other = positions(joint.mimics->joint);
        const double position = other ? joint.mimics->multiplier * *other + joint.mimics->offset : Infinite;
        if (isSane(position)) return position;
    }
    return atRest(joint);
}

Pose motionOf(const ModelJoint& joint, const JointPositions& positions) {
    Pose motion = Pose::Identity();
    switch (joint.type) {
        case ModelJointType::Fixed:
            break;
        case ModelJointType::Revolute:
        case ModelJointType::Continuous:
            motion.linear() = Eigen::AngleAxisd(positionOf(joint, positions), joint.axis).toRotationMatrix();
            break;
        case ModelJointType::Prismatic:
            motion.translation() = positionOf(joint, positions) * joint.axis;
            break;
    }
    return motion;
}

}  // namespace

std::optional<std::size_t> RobotModel::linkAt(std::string_view name) const {
    const auto found = std::find_if(links.begin(), links.end(), [&](const ModelLink& link) {
        return withoutPrefix(link.name) == withoutPrefix(name);
    });
    if (found == links.end()) return std::nullopt;
    return static_cast<std::size_t>(found - links.begin());
}

std::vector<Pose> linksInBase(const RobotModel& model, std::size_t base, const JointPositions& positions) {
    std::vector<Pose> poses(model.links.size(), Pose::Identity());
    for (const ModelJoint& joint : model.joints)
        poses[joint.child] = poses[joint.parent] * joint.jointInParent * motionOf(joint, positions);
    const Pose rootInBase = poses.at(base).inverse();
    for (Pose& pose : poses) pose = rootInBase * pose;
    return poses;
}

}  // namespace leitstand
