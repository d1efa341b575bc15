#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/time.h"
#include "core/robot/joints/joint_group.h"

namespace leitstand {

struct JointSample;

/// What decides, besides the operator, whether joints move.
struct JointConditions {
    bool mayMove = false;  ///< the grant to drive is held, the link is there, and no stop is in force
    bool hold = false;     ///< a stop is in force that the robot does not take by itself
    bool heard = true;     ///< the robot's link is there
};

/// A command to joints: one number for each joint, in the order of the group.
struct JointSetpoints {
    JointCommandMode mode = JointCommandMode::Position;  ///< what the numbers are
    std::vector<double> values;                          ///< [rad, m], or each per second
    friend bool operator==(const JointSetpoints&, const JointSetpoints&) = default;
};

/// What a group does now.
enum class JointMotion : std::uint8_t {
    Still,
    ByHand,
    ToPreset,
    Blocked,     ///< a preset was given up, because the joints came no nearer to it
    Unreported,  ///< a motion was refused, because the robot does not tell where these joints are
};

/// A group of joints now.
struct JointGroupView {
    std::vector<std::optional<double>> positions;  ///< of each joint; empty: unknown
    JointMotion motion = JointMotion::Still;
    std::optional<std::size_t> preset;  ///< the one that is approached
    bool mayMove = false;               ///< JointConditions::mayMove
    friend bool operator==(const JointGroupView&, const JointGroupView&) = default;
};

/// The operator's control of one group of joints. Motions by hand end when they are not renewed. A preset is
/// approached no faster than each joint's rate; any other motion, a halt, a stop or the loss of the grant
/// ends it. Velocities end with zeros until the joints are seen to stand, also after a gap of the link.
/// Positions end where the joints are. They never lead a joint by more than half a second of its rate, so
/// that a blocked joint does not leap when it comes free. While a stop is in force, velocities are zero;
/// positions are held for half a second and then no longer commanded, since an arm without power may sink.
/// Pure: no clock, no thread.
class JointControl {
public:
    explicit JointControl(JointGroup group);

    /// Takes the robot's joint states; joints of others in it do not matter.
    void reported(const JointSample& joints, SteadyTime now);
    /// Moves @p axis of the group at @p share of its joints' rates, -1 (down) to 1 (up), for 200 ms. A share
    /// other than 0 counts only after one of 0, where something else than the operator ended the motion.
    void move(std::size_t axis, double share, SteadyTime now);
    void goTo(std::size_t preset, SteadyTime now);
    void halt();  ///< ends a motion; by hand, only a share of 0 makes another one possible

    /// Returns what to send now. Call about 20 times a second.
    [[nodiscard]] std::optional<JointSetpoints> due(const JointConditions& conditions, SteadyTime now);

    [[nodiscard]] const JointGroup& group() const { return m_group; }
    [[nodiscard]] JointMotion motion() const { return m_motion; }
    /// The preset that is approached; empty: none.
    [[nodiscard]] std::optional<std::size_t> preset() const { return m_preset; }
    /// Where @p joint was reported within the last second; empty: unknown.
    [[nodiscard]] std::optional<double> position(std::size_t joint, SteadyTime now) const;
    /// Whether something moves, or its end is not all said yet.
    [[nodiscard]] bool isMoving() const { return moves() || m_ending; }

private:
    struct Joint {
        std::optional<double> position;
        SteadyTime reported = {}, moved = {};  ///< when it was last reported, and at another position
        std::optional<double> target;          ///< commanded last
    };
    [[nodiscard]] bool moves() const {
        return m_motion == JointMotion::ByHand || m_motion == JointMotion::ToPreset;
    }
    [[nodiscard]] bool isKnown(SteadyTime now) const;
    [[nodiscard]] bool stands(SteadyTime now) const;
    /// Ends a motion. If something moved, its end remains to be said.
    void end(SteadyTime now, JointMotion why = JointMotion::Still);
    /// Sets the targets from which a motion begins.
    void begin(SteadyTime now);
    [[nodiscard]] double goal(std::size_t joint) const;
    /// Empty: the place of a joint is not known.
    [[nodiscard]] std::optional<JointSetpoints> targets() const;
    [[nodiscard]] JointSetpoints zeros() const;
    [[nodiscard]] std::optional<JointSetpoints> held(SteadyTime now);
    [[nodiscard]] std::optional<JointSetpoints> byHand(double seconds, SteadyTime now);
    [[nodiscard]] std::optional<JointSetpoints> toPreset(double seconds, SteadyTime now);
    /// Returns what says the end of the last motion.
    [[nodiscard]] std::optional<JointSetpoints> ending(const JointConditions& conditions, SteadyTime now);
    /// Moves a target, no farther ahead of the joint than it may be.
    void lead(std::size_t joint, double target, SteadyTime now);

    JointGroup m_group;
    std::vector<Joint> m_joints;
    JointMotion m_motion = JointMotion::Still;
    std::size_t m_axis = 0;
    double m_share = 0.0;
    bool m_needsRest = false;  ///< the control must be let go first
    std::optional<std::size_t> m_preset;
    double m_nearest = 0.0;  ///< smallest sum of errors on the way to the preset
    bool m_ending = false;   ///< the end of a motion is not all said yet
    SteadyTime m_renewed = {}, m_nearer = {}, m_due = {}, m_ended = {};
    SteadyTime m_sent = {};  ///< when targets were last commanded
    std::optional<SteadyTime> m_heldSince;
};

}  // namespace leitstand
