#pragma once

#include <QString>

#include "core/station/robot_view.h"
#include "widgets/models/tone.h"

namespace leitstand {

/// What the driver must know about the picture and the speed limit that follows from it.
struct SightLine {
    QString text;  ///< "creep speed: the picture is 0.6 s old"; empty while the driver sees well
    Tone tone = Tone::Muted;
};
[[nodiscard]] SightLine sightLineOf(const DriveView& drive);
/// Returns the speed limit in short, to be shown beside the age of the driver's picture: "full speed", "creep
/// speed", "held". Empty when the sticks are not on this robot.
[[nodiscard]] QString sightNote(const DriveView& drive);

}  // namespace leitstand
