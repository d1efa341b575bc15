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
    Stopped,  ///< the robot stands and nobody drives it
    Stop,     ///< a stop is in force
    Lost,     ///< the robot is not heard, so what it does is unknown
};

/// The mode of a robot, for the largest text of the window.
struct ModeLabel {
    ModeKind kind = ModeKind::Stopped;
    QString text;        ///< "TELEOPERATION"
    QString reason;      ///< why, as the robot reports; "body heat in sight"; may be empty
    QString brief = {};  ///< the text for narrow places: "SAFE TELEOP"

    friend bool operator==(const ModeLabel&, const ModeLabel&) = default;
};

/// Returns the label for what @p robot does. If its link is lost, the label says so; otherwise whether it is
/// stopped, or else its reported mode.
[[nodiscard]] ModeLabel modeLabelOf(const RobotView& robot, const LatestPtr<ModeSample>& reported);

/// Whether @p robot drives itself, as far as is known: its last report says so, and no stop is in force. This
/// includes robots whose link is lost, since they continue to drive.
[[nodiscard]] bool drivesItself(const RobotView& robot, const LatestPtr<ModeSample>& reported);

/// Returns @p reported, a robot's text about itself, in the window's language. Texts that are not in
/// robot_format.h are not changed.
[[nodiscard]] QString robotReasonText(const std::string& reported);

/// Returns the name of a robot's mode for people: "victim approach" for "victim_approach".
[[nodiscard]] QString modeName(const std::string& mode);
/// Returns a shorter name for narrow places: "approach".
[[nodiscard]] QString modeBrief(const std::string& mode);

}  // namespace leitstand
