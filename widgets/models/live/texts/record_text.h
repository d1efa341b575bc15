#pragma once

#include <QString>
#include <QStringList>

#include "widgets/models/tone.h"

namespace leitstand {

/// The state of the mission's log.
struct RecordState {
    QString folder = {};          ///< of the mission
    double megabytes = 0.0;       ///< written in this session
    double minutesLeft = 0.0;     ///< until the disk is full; infinite: nothing is written
    unsigned long long lost = 0;  ///< events that will never be written; pictures do not count
    QString problem = {};         ///< why nothing can be written; empty: all is well
};

/// The log in words.
struct RecordText {
    QString value;    ///< "rec", "not recording"
    QString details;  ///< folder, size, how long the disk lasts
    Tone tone = Tone::Muted;

    friend bool operator==(const RecordText&, const RecordText&) = default;
};

/// Returns the log in words. The tone is Muted while all is written, Attention when the disk lasts less than
/// 10 min, and Act when something was lost or nothing is written.
[[nodiscard]] RecordText recordText(const RecordState& state);

/// Returns every possible RecordText::value, with figures at their widest.
[[nodiscard]] QStringList recordValues();

}  // namespace leitstand
