#pragma once

#include <QString>
#include <QStringList>

#include "core/mission/state/mission_clock.h"
#include "widgets/models/tone.h"

namespace leitstand {

/// The mission's clock in words.
struct ClockText {
    QString caption;  ///< "left", "over", "time", "paused"
    QString value;    ///< "12:41"
    QString details;  ///< for people who ask: "7:19 of 20:00, running"
    Tone tone = Tone::Normal;

    friend bool operator==(const ClockText&, const ClockText&) = default;
};

/// Counts down where the mission has a length: attention for the last two minutes, act when they are over. A
/// clock that stands says so.
[[nodiscard]] ClockText clockText(const MissionClock& clock);

/// Each ClockText::caption that there is.
[[nodiscard]] QStringList clockCaptions();

}  // namespace leitstand
