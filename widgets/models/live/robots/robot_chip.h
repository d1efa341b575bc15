#pragma once

#include <QStringList>

#include "core/station/robot_view.h"
#include "widgets/models/live/robots/robot_face.h"
#include "widgets/models/live/texts/mode_label.h"
#include "widgets/models/tone.h"

namespace leitstand {

struct RobotState;

/// A robot in the bar at the top.
struct RobotChip {
    RobotFace face;
    LinkState link = LinkState::NeverSeen;  ///< shown as a circle, square, cross or ring
    ModeKind mode = ModeKind::Stopped;
    Tone tone = Tone::Muted;  ///< Attention if the link is lost; lesser faults are only shown by the mark
    /// Texts about link and battery, the longest first. Each following text leaves out more: first a loss of
    /// 0 %, then any loss, then the round trip or the fault of the link. With a lost link there are two: the
    /// time of silence with the battery, and the time alone. Empty: the robot was never heard.
    QStringList figures;
    QStringList modes;  ///< texts about what the robot does, the longest first: "teleoperation", "teleop"
    QString details;    ///< the full text, for tooltips and screen readers

    friend bool operator==(const RobotChip&, const RobotChip&) = default;
};

/// @p now: station's clock.
[[nodiscard]] RobotChip robotChipOf(const RobotFace& face, const RobotView& robot, const RobotState& reported,
                                    Time now);

}  // namespace leitstand
