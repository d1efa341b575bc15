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
    QString details;  ///< full text: "7:19 of 20:00, running"
    Tone tone = Tone::Normal;

    friend bool operator==(const ClockText&, const ClockText&) = default;
};

/// Returns the clock in words. It counts down if the mission has a length. The tone is Attention for the last
/// two minutes, and Act after the end. A stopped clock has the caption "paused".
[[nodiscard]] ClockText clockText(const MissionClock& clock);

/// Returns every possible ClockText::caption.
[[nodiscard]] QStringList clockCaptions();

}  // namespace leitstand
