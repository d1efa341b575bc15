#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <limits>
#include <span>

#include "core/base/time.h"

namespace leitstand {

/// Identity of a goal of an action (unique_identifier_msgs/msg/UUID).
using GoalId = std::array<std::uint8_t, 16>;

/// What became of the goal that a robot was sent to.
enum class GoalStage : std::uint8_t {
    None,        ///< no goal was sent
    Asked,       ///< it was sent, but not answered yet
    UnderWay,    ///< it was accepted
    Cancelling,  ///< it is asked to give up
    Arrived,
    Cancelled,
    Failed,      ///< the robot gave up
    Refused,     ///< the robot did not accept it
    Unanswered,  ///< nobody answered within 3 s
};

/// A robot's own navigation, as the operator sees it.
struct NavigationView {
    bool known = false;    ///< whether the robot's file names one
    bool offered = false;  ///< whether anybody offers it now
    GoalStage stage = GoalStage::None;
    double metresLeft = std::numeric_limits<double>::quiet_NaN();   ///< way that is left [m]; NaN: unknown
    double secondsLeft = std::numeric_limits<double>::quiet_NaN();  ///< time that is left [s]; NaN: unknown
    int recoveries = 0;  ///< how often it got stuck on the way and freed itself
};

/// Follows one goal of an action from its request to its end. Pure.
///
/// A new goal replaces the one before, whose reports are then ignored. What the answers to requests leave
/// open, the robot's status decides: it also reports goals that ended while the link was lost.
class GoalTracker {
public:
    static constexpr std::chrono::seconds Patience{3};

    /// States of action_msgs/msg/GoalStatus.
    enum class Status : std::int8_t { Unknown, Accepted, Executing, Canceling, Succeeded, Canceled, Aborted };
    struct Report {
        GoalId goal{};
        Status status = Status::Unknown;
    };

    void asked(const GoalId& goal, SteadyTime now);
    /// Takes the answer to the request of @p goal.
    void answered(const GoalId& goal, bool accepted);
    void cancelling();  ///< notes that the goal was asked to be given up
    void reported(std::span<const Report> goals);
    /// Takes how much is left of the way to @p goal [m, s].
    void progressed(const GoalId& goal, double metres, double seconds, int recoveries);

    [[nodiscard]] const GoalId& goal() const { return m_goal; }
    /// Whether a goal was sent and has not ended.
    [[nodiscard]] bool isOpen(SteadyTime now) const;
    /// Leaves NavigationView::known and ::offered as they are by default.
    [[nodiscard]] NavigationView view(SteadyTime now) const;

private:
    [[nodiscard]] bool hasEnded() const;

    GoalId m_goal{};
    SteadyTime m_asked = {};
    NavigationView m_view;
};

}  // namespace leitstand
