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
    Lost,     ///< it is not heard: what it does is unknown
};

/// The mode of a robot, as the largest text of the window shows it.
struct ModeLabel {
    ModeKind kind = ModeKind::Stopped;
    QString text;        ///< "TELEOPERATION"
    QString reason;      ///< why, by the robot: "body heat in sight"; may be empty
    QString brief = {};  ///< the text where there is little room: "SAFE TELEOP"

    friend bool operator==(const ModeLabel&, const ModeLabel&) = default;
};

/// Returns what @p robot does. A lost link comes before a stop, which comes before what the robot reported.
[[nodiscard]] ModeLabel modeLabelOf(const RobotView& robot, const LatestPtr<ModeSample>& reported);

/// Whether @p robot drives itself, as far as is known: it reported so last, and no stop stands. A robot whose
/// link is lost goes on by itself.
[[nodiscard]] bool drivesItself(const RobotView& robot, const LatestPtr<ModeSample>& reported);

/// Returns what a robot reported about itself, in the window's language as far as the words are known
/// (robot_format.h), otherwise as it was reported.
[[nodiscard]] QString robotReasonText(const std::string& reported);

/// Returns the name of a mode of robots, "victim_approach", for people: "victim approach".
[[nodiscard]] QString modeName(const std::string& mode);
/// Returns the same for little room: "approach".
[[nodiscard]] QString modeBrief(const std::string& mode);

}  // namespace leitstand
