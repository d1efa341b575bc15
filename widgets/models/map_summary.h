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
    bool stale = false;        ///< nothing came to it lately: it is greyed
    QString briefTitle = {};   ///< for where both have no room; empty: as the title
    QString briefResult = {};  ///< likewise
};

/// Sums @p map up; overlap is the lowest of all scans, time the sum.
[[nodiscard]] MapSummary summaryOf(const Map& map);

}  // namespace leitstand
