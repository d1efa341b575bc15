#pragma once

#include <QStringList>

#include "core/station/robot_view.h"
#include "widgets/models/live/robots/robot_face.h"
#include "widgets/models/live/texts/mode_label.h"
#include "widgets/models/tone.h"

namespace leitstand {

struct RobotState;

/// A robot in the bar on top.
struct RobotChip {
    RobotFace face;
    LinkState link = LinkState::NeverSeen;  ///< its mark: circle, square, cross, ring
    ModeKind mode = ModeKind::Stopped;
    Tone tone = Tone::Muted;  ///< Attention when the link is lost; the mark shows lesser faults
    /// Its link and battery, the longest first. Each next one leaves out more: that nothing is lost, what is
    /// lost, how slow it is. All contain the battery; when the robot is not heard, all contain for how long.
    QStringList figures;
    QStringList modes;  ///< what it does, the longest first: "teleoperation", "teleop"
    QString details;    ///< the full text, for tooltips and screen readers

    friend bool operator==(const RobotChip&, const RobotChip&) = default;
};

/// @p now: station's clock.
[[nodiscard]] RobotChip robotChipOf(const RobotFace& face, const RobotView& robot, const RobotState& reported,
                                    Time now);

}  // namespace leitstand
