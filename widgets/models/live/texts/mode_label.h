#pragma once

#include <optional>

#include <QString>

#include "core/mission/state/robot_state.h"
#include "core/station/robot_view.h"

namespace leitstand {

/// What the background of a mode says.
enum class ModeKind {
    Teleoperation,
    Autonomous,
    Stopped,  ///< stands, nobody drives it
    Stop,     ///< a stop stands
    Lost,     ///< nothing is heard of it: what it does is not known
};

/// The mode of a robot, as the largest text of the window has it.
struct ModeLabel {
    ModeKind kind = ModeKind::Stopped;
    QString text;        ///< "TELEOPERATION"
    QString reason;      ///< why, by the robot: "body heat in sight"; may be empty
    QString brief = {};  ///< the text where there is little room: "SAFE TELEOP"

    friend bool operator==(const ModeLabel&, const ModeLabel&) = default;
};

/// What @p robot does. A lost link comes before a stop, which comes before what the robot said.
[[nodiscard]] ModeLabel modeLabelOf(const RobotView& robot, const std::optional<Latest<ModeSample>>& said);

/// Whether @p robot drives itself as far as anybody knows: so it said last, and no stop stands. One whose
/// link is lost goes on by itself.
[[nodiscard]] bool drivesItself(const RobotView& robot, const std::optional<Latest<ModeSample>>& said);

/// What a robot said about itself, in the window's language as far as the words are known (robot_says.h),
/// else as it was said.
[[nodiscard]] QString robotSaysText(const std::string& said);

/// The name of a mode as robots say it, "victim_approach", for people: "victim approach".
[[nodiscard]] QString modeName(const std::string& mode);
/// The same where there is little room: "approach".
[[nodiscard]] QString modeBrief(const std::string& mode);

}  // namespace leitstand
