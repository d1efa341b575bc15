#pragma once

#include <QString>

#include "core/station/robot_view.h"
#include "widgets/models/tone.h"

namespace leitstand {

/// What the driver must know about the picture, and the speed limit that results from it.
struct SightLine {
    QString text;  ///< "creep speed: the picture is 0.6 s old"; empty if there is no restriction
    Tone tone = Tone::Muted;
};
[[nodiscard]] SightLine sightLineOf(const DriveView& drive);
/// Returns the speed limit as a short text beside the age of the driver's picture: "full speed", "creep
/// speed", "held". Empty when the sticks do not drive this robot.
[[nodiscard]] QString sightNote(const DriveView& drive);

}  // namespace leitstand
