#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace leitstand {

/// As in URDF. Angles are in rad, lengths in m. A revolute joint without limits turns for ever
/// ("continuous").
enum class JointType : std::uint8_t { Revolute, Prismatic };
[[nodiscard]] std::string toString(JointType type);

/// What the numbers in a group's commands are.
enum class JointCommandMode : std::uint8_t { Position, Velocity };
[[nodiscard]] std::string toString(JointCommandMode mode);

/// How a joint's link is drawn, seen from the robot's right: x to the right, z up.
struct JointLink {
    /// Where the link begins: in the base frame, or from the parent's end in the base frame's axes [m].
    Eigen::Vector2d place = Eigen::Vector2d::Zero();
    double length = 0.0;  ///< [m]
    /// Direction of the link when the joint is at 0, counted from ahead upwards [rad]; with a parent, from
    /// the parent's direction.
    double zero = 0.0;
    std::string parent;  ///< joint at whose end it begins; empty: the base
    friend bool operator==(const JointLink&, const JointLink&) = default;
};

/// A joint that the operator moves. Positions: [rad] or [m] by its type.
struct MovedJoint {
    std::string name;  ///< as in joint_states
    JointType type = JointType::Revolute;
    std::optional<double> lower, upper;  ///< empty: no limit
    double rate = 0.0;                   ///< fastest [rad/s or m/s]
    bool reversed = false;               ///< whether "up" is its negative direction
    std::optional<JointLink> link;       ///< empty: it is not drawn
    friend bool operator==(const MovedJoint&, const MovedJoint&) = default;

    /// Returns @p position within the limits.
    [[nodiscard]] double within(double position) const;
};

/// Joints that one control moves together, "front flippers".
struct JointAxis {
    std::string title;
    std::vector<std::size_t> joints;  ///< indices of JointGroup::joints
    friend bool operator==(const JointAxis&, const JointAxis&) = default;
};

/// A pose of all joints of a group that is asked for by name (a group state in SRDF).
struct JointPreset {
    std::string title;
    std::vector<double> positions;  ///< one for each joint
    friend bool operator==(const JointPreset&, const JointPreset&) = default;
};

/// What the operator moves beside driving: flippers, an arm. Its commands are the robot's stream with the
/// role joint_command and this group.
struct JointGroup {
    static constexpr std::size_t MostJoints = 32, MostPresets = 32;

    std::string name, title;
    JointCommandMode mode = JointCommandMode::Position;
    std::vector<MovedJoint> joints;  ///< in the order of commands without names
    std::vector<JointAxis> axes;     ///< what controls move; each joint by itself if the file names none
    std::vector<JointPreset> presets;
    friend bool operator==(const JointGroup&, const JointGroup&) = default;

    [[nodiscard]] std::optional<std::size_t> indexOf(const std::string& joint) const;
};

}  // namespace leitstand
