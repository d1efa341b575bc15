#pragma once

#include <QString>

#include "core/mapping/map.h"
#include "widgets/models/tone.h"

namespace leitstand {

/// A summary of the map on one line, for the title of its pane.
struct MapSummary {
    QString title;   ///< "3D map · 3 scans · 0.24 M points"
    QString result;  ///< "registered in 0.4 s · overlap 83 % · certain"; empty before the second scan
    Tone tone = Tone::Normal;  ///< tone of the result: Attention if a scan is not certain
    QString hint = {};         ///< what the result means
    bool stale = false;        ///< whether nothing was added recently, so that the map is grey
    QString briefTitle = {};   ///< title if there is not enough space for both; empty: the same
    QString briefResult = {};  ///< result if there is not enough space for both; empty: the same
};

/// Returns the summary of @p map, with the lowest overlap of all scans and the sum of their times.
[[nodiscard]] MapSummary summaryOf(const Map& map);

}  // namespace leitstand
