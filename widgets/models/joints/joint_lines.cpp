#include "widgets/models/joints/joint_lines.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace leitstand {
namespace {

/// Where a link lies; empty: unknown.
struct Placed {
    Eigen::Vector2d from, to;
    double direction = 0.0;  ///< counted from ahead upwards [rad]
};

Eigen::Vector2d along(double direction) {
    return {std::cos(direction), std::sin(direction)};
}

Placed place(const MovedJoint& joint, double position, const Placed* parent) {
    const JointLink& link = *joint.link;
    const double raised = joint.reversed ? -position : position;
    Placed placed;
    placed.from = link.place;
    placed.direction = link.zero;
    if (parent != nullptr) {
        placed.from += parent->to;
        placed.direction += parent->direction;
    }
    double length = link.length;
    if (joint.type == JointType::Prismatic) {
        length += position;
    } else if (parent == nullptr && std::abs(link.zero) > std::numbers::pi / 2) {
        placed.direction -= raised;  // one that points behind is raised the other way round
    } else {
        placed.direction += raised;
    }
    placed.to = placed.from + length * along(placed.direction);
    return placed;
}

}  // namespace

std::vector<JointLine> jointLines(const JointGroup& group,
                                  const std::vector<std::optional<double>>& positions,
                                  std::optional<std::size_t> axis) {
    std::vector<std::optional<Placed>> placed(group.joints.size());
    std::vector<JointLine> lines;
    for (std::size_t i = 0; i < std::min(group.joints.size(), positions.size()); ++i) {
        const MovedJoint& joint = group.joints[i];
        if (!joint.link || !positions[i]) continue;
        const Placed* parent = nullptr;
        if (!joint.link->parent.empty()) {
            const auto at = group.indexOf(joint.link->parent);
            if (!at || *at >= i || !placed[*at]) continue;
            parent = &*placed[*at];
        }
        placed[i] = place(joint, *positions[i], parent);
        JointLine line{placed[i]->from, placed[i]->to};
        if (axis && *axis < group.axes.size()) {
            const auto& moved = group.axes[*axis].joints;
            line.chosen = std::find(moved.begin(), moved.end(), i) != moved.end();
        }
        lines.push_back(line);
    }
    return lines;
}

SideView bodyFromTheSide(const RobotDescription& robot) {
    SideView body{{0.0, 0.0}, {0.0, robot.height}};
    for (const Eigen::Vector2d& corner : robot.footprint) {
        body.low.x() = std::min(body.low.x(), corner.x());
        body.high.x() = std::max(body.high.x(), corner.x());
    }
    return body;
}

SideView reachFromTheSide(const RobotDescription& robot, const std::vector<JointLine>& lines) {
    SideView all = bodyFromTheSide(robot);
    const auto add = [&all](const Eigen::Vector2d& low, const Eigen::Vector2d& high) {
        all.low = all.low.cwiseMin(low);
        all.high = all.high.cwiseMax(high);
    };
    for (const JointGroup& group : robot.jointGroups) {
        for (const MovedJoint& joint : group.joints) {
            if (!joint.link || !joint.link->parent.empty()) continue;
            const bool carries = std::any_of(
                group.joints.begin(), group.joints.end(),
                [&](const MovedJoint& other) { return other.link && other.link->parent == joint.name; });
            if (carries) continue;
            const Eigen::Vector2d reach = Eigen::Vector2d::Constant(joint.link->length);
            add(joint.link->place - reach, joint.link->place + reach);
        }
    }
    for (const JointLine& line : lines) add(line.from.cwiseMin(line.to), line.from.cwiseMax(line.to));
    return all;
}

}  // namespace leitstand
