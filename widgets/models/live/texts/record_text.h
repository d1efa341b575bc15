#pragma once

#include <QString>
#include <QStringList>

#include "widgets/models/tone.h"

namespace leitstand {

/// The state of the mission's log.
struct RecordState {
    QString folder = {};          ///< folder of the mission
    double megabytes = 0.0;       ///< written in this session
    double minutesLeft = 0.0;     ///< time until the disk is full; infinite: nothing is written
    unsigned long long lost = 0;  ///< number of events that will never be written, without pictures
    QString problem = {};         ///< why nothing can be written; empty: there is no problem
};

/// The log in words.
struct RecordText {
    QString value;    ///< "rec", "not recording"
    QString details;  ///< folder, size, and how long the disk will last
    Tone tone = Tone::Muted;

    friend bool operator==(const RecordText&, const RecordText&) = default;
};

/// Returns the log in words. The tone is Muted while everything is written. It is Attention if the disk will
/// be full within 10 min, and Act if something was lost or nothing is written.
[[nodiscard]] RecordText recordText(const RecordState& state);

/// Returns every possible RecordText::value, with the widest figures.
[[nodiscard]] QStringList recordValues();

}  // namespace leitstand
