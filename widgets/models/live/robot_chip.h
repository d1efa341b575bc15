#pragma once

#include <QStringList>

#include "core/mission/robot_state.h"
#include "core/robot/robot_view.h"
#include "widgets/models/live/mode_label.h"
#include "widgets/models/live/robot_face.h"
#include "widgets/models/tone.h"

namespace leitstand {

/// A robot in the bar on top.
struct RobotChip {
    RobotFace face;
    LinkState link = LinkState::NeverSeen;  ///< its mark: circle, square, cross, ring
    ModeKind mode = ModeKind::Stopped;
    Tone tone = Tone::Muted;  ///< Attention when the link is lost; the mark tells of what is less
    /// What is told of it, the longest first; each leaves out something more: the name, that nothing is
    /// lost, words of the mode, and only then the link's figures. Mode and battery are in all.
    QStringList texts;
    QString details;  ///< every word of it, for tooltips and screen readers

    friend bool operator==(const RobotChip&, const RobotChip&) = default;
};

/// @p now: station's clock.
[[nodiscard]] RobotChip robotChipOf(const RobotFace& face, const RobotView& robot, const RobotState& said,
                                    Time now);

}  // namespace leitstand
