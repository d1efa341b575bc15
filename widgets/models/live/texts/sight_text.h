#pragma once

#include <QString>

#include "core/station/robot_view.h"
#include "widgets/models/tone.h"

namespace leitstand {

/// What the driver must know of the cap on the speed.
struct SightLine {
    QString text;  ///< "creep speed: the picture is 0.6 s old"; empty when nothing is capped
    Tone tone = Tone::Muted;
};
[[nodiscard]] SightLine sightLineOf(const DriveView& drive);
/// Returns it in short, beside the age of the driver's picture: "full speed", "creep speed"; empty when
/// nobody drives.
[[nodiscard]] QString sightNote(const DriveView& drive);

}  // namespace leitstand
