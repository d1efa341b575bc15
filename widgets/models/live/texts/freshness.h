#pragma once

#include <limits>

#include <QString>

#include "widgets/models/tone.h"

namespace leitstand {

/// How far what a pane shows can be believed to be of now.
enum class Freshness {
    Live,
    Stale,  ///< greyed: too old to act on
    Lost,   ///< not shown as if it were alive
    Never,  ///< nothing came yet
};

/// From which age data are stale and lost [s].
struct FreshnessLimits {
    double stale = 1.0, lost = 3.0;
};

/// The age of what a pane shows.
struct DataAge {
    double arrival = std::numeric_limits<double>::infinity();  ///< since it came [s]; infinite: never
    /// Since what came was something new: a frozen sender repeats itself under new stamps [s].
    double content = 0.0;

    [[nodiscard]] double seconds() const { return arrival > content ? arrival : content; }
};

[[nodiscard]] Freshness freshnessOf(const DataAge& age, const FreshnessLimits& limits = {});

/// An age as it stands in the corner of a pane: "64 ms", "1.4 s".
[[nodiscard]] QString secondsText(double seconds);
/// "64 ms"; "same for 2.4 s" where the content repeats itself; "no data" when it is lost or never came.
[[nodiscard]] QString ageText(const DataAge& age, const FreshnessLimits& limits = {});
/// What stands across a pane: "no data for 4 s", "the same picture for 4 s", "no data yet"; empty while it is
/// not lost.
[[nodiscard]] QString lossText(const DataAge& age, const FreshnessLimits& limits = {});
[[nodiscard]] Tone toneOf(Freshness freshness);

}  // namespace leitstand
