#pragma once

#include <QString>

#include "core/mapping/map.h"
#include "widgets/models/tone.h"

namespace leitstand {

/// The map in a line, for the title of its pane.
struct MapSummary {
    QString title;   ///< "3D map · 3 scans · 0.24 M points"
    QString result;  ///< "registered in 0.4 s · overlap 83 % · certain"; empty before the second scan
    Tone tone = Tone::Normal;  ///< of the result: Attention when a scan is not certain
    QString hint = {};         ///< what the result means
    bool stale = false;        ///< nothing was added lately, so the map is greyed
    QString briefTitle = {};   ///< the title when there is no room for both; empty: the same
    QString briefResult = {};  ///< the result when there is no room for both; empty: the same
};

/// Returns the summary of @p map: the lowest overlap of all scans and the sum of their times.
[[nodiscard]] MapSummary summaryOf(const Map& map);

}  // namespace leitstand
