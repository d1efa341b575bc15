#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "core/base/pose.h"

namespace leitstand {

// The shapes of URDF's <geometry>, each in the axes of its part.
struct BoxShape {
    Eigen::Vector3d size = Eigen::Vector3d::Zero();  ///< around the origin [m]
};
struct CylinderShape {
    double radius = 0.0, length = 0.0;  ///< around z, half of it above the origin [m]
};
struct SphereShape {
    double radius = 0.0;  ///< [m]
};
struct MeshShape {
    std::string uri;                                  ///< "package://husky_description/meshes/base.dae"
    Eigen::Vector3d scale = Eigen::Vector3d::Ones();  ///< along the axes of the mesh
};
using PartShape = std::variant<BoxShape, CylinderShape, SphereShape, MeshShape>;

/// Red, green and blue, 0 to 1.
using PartColour = Eigen::Vector3f;

/// A part of a link: URDF's <visual> or <collision>.
struct LinkPart {
    Pose partInLink = Pose::Identity();
    PartShape shape;
    std::optional<PartColour> colour;  ///< empty: the colours of the mesh, or none are given
};

/// A rigid part of a robot.
struct ModelLink {
    std::string name;
    std::vector<LinkPart> visuals, collisions;
};

/// How a joint moves. A floating or planar joint counts as fixed: no number tells its place.
enum class ModelJointType : std::uint8_t { Fixed, Revolute, Continuous, Prismatic };

/// A joint that follows another one: its position is multiplier * other + offset.
struct MimickedJoint {
    std::string joint;
    double multiplier = 1.0, offset = 0.0;
};

/// What connects two links.
struct ModelJoint {
    std::string name;  ///< as in joint_states
    ModelJointType type = ModelJointType::Fixed;
    std::size_t parent = 0, child = 0;  ///< indices of RobotModel::links
    Pose jointInParent = Pose::Identity();
    Eigen::Vector3d axis = Eigen::Vector3d::UnitX();  ///< unit vector in the joint's axes
    std::optional<double> lower, upper;               ///< [rad] or [m]; empty: no limit is given
    std::optional<MimickedJoint> mimics;
};

/// The links and joints of a robot (URDF, REP 120 names): a tree.
struct RobotModel {
    static constexpr std::size_t MostLinks = 2000, MostParts = 10'000;

    std::string name;
    std::vector<ModelLink> links;
    std::vector<ModelJoint> joints;  ///< those nearer to the root come first
    std::size_t root = 0;            ///< index of the link that has no parent

    /// Returns the index of the link @p name, with or without a robot's prefix ("husky/base_link").
    [[nodiscard]] std::optional<std::size_t> linkAt(std::string_view name) const;
};

/// Returns the position of a joint [rad or m]; empty: unknown.
using JointPositions = std::function<std::optional<double>(const std::string& joint)>;

/// Returns the pose of each link in the link at @p base, in the order of RobotModel::links. Joints whose
/// positions are unknown, or make no sense, are at 0, or at the limit that is nearest to 0.
[[nodiscard]] std::vector<Pose> linksInBase(const RobotModel& model, std::size_t base,
                                            const JointPositions& positions);

}  // namespace leitstand
