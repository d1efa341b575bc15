#pragma once

#include <limits>

#include <QString>

#include "widgets/models/tone.h"

namespace leitstand {

/// How current the data in a pane are.
enum class Freshness {
    Live,
    Stale,  ///< shown in grey: too old to act on
    Lost,   ///< too old to be shown like live data
    Never,  ///< nothing was received yet
};

/// Ages from which data are stale or lost [s].
struct FreshnessLimits {
    double stale = 1.0, lost = 3.0;
};

/// The age of what a pane shows.
struct DataAge {
    double arrival = std::numeric_limits<double>::infinity();  ///< since it was received [s]; infinite: never
    /// Since the content last changed [s]. It increases while a sender that hangs repeats one sample with new
    /// stamps.
    double content = 0.0;

    [[nodiscard]] double seconds() const { return arrival > content ? arrival : content; }
};

[[nodiscard]] Freshness freshnessOf(const DataAge& age, const FreshnessLimits& limits = {});

/// Returns an age for the corner of a pane: "64 ms", "1.4 s".
[[nodiscard]] QString secondsText(double seconds);
/// Returns "64 ms"; "same for 2.4 s" when the content does not change; "no data yet" when none was ever
/// received.
[[nodiscard]] QString ageText(const DataAge& age, const FreshnessLimits& limits = {});
/// Returns the text across a pane: "no data for 4 s", "the same picture for 4 s", "no data yet". Empty while
/// the data are not lost.
[[nodiscard]] QString lossText(const DataAge& age, const FreshnessLimits& limits = {});
[[nodiscard]] Tone toneOf(Freshness freshness);

}  // namespace leitstand
