#pragma once

#include <optional>

#include <QString>

#include "core/event/status_samples.h"
#include "core/mission/state/robot_state.h"
#include "core/station/robot_view.h"

namespace leitstand {

/// What the background of a mode shows.
enum class ModeKind {
    Teleoperation,
    Autonomous,
    Stopped,  ///< stands, nobody drives it
    Stop,     ///< a stop stands
    Lost,     ///< the robot is not heard: what it does is unknown
};

/// The mode of a robot, as the largest text of the window shows it.
struct ModeLabel {
    ModeKind kind = ModeKind::Stopped;
    QString text;        ///< "TELEOPERATION"
    QString reason;      ///< why, as the robot reports: "body heat in sight"; may be empty
    QString brief = {};  ///< the text where there is little room: "SAFE TELEOP"

    friend bool operator==(const ModeLabel&, const ModeLabel&) = default;
};

/// Returns the label for what @p robot does: that its link is lost, else that it is stopped, else the mode
/// that it reported.
[[nodiscard]] ModeLabel modeLabelOf(const RobotView& robot, const LatestPtr<ModeSample>& reported);

/// Whether @p robot drives itself, as far as is known: its last report says so, and no stop stands. That
/// holds with a lost link, too: such a robot drives on.
[[nodiscard]] bool drivesItself(const RobotView& robot, const LatestPtr<ModeSample>& reported);

/// Returns @p reported, a robot's text about itself, in the window's language. Texts that robot_format.h does
/// not list stay as they are.
[[nodiscard]] QString robotReasonText(const std::string& reported);

/// Returns the name of a mode of robots, "victim_approach", for people: "victim approach".
[[nodiscard]] QString modeName(const std::string& mode);
/// Returns a shorter name for little room: "approach".
[[nodiscard]] QString modeBrief(const std::string& mode);

}  // namespace leitstand
