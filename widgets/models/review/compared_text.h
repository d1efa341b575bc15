#pragma once

#include <QString>

#include "core/mapping/comparison/map_comparison.h"
#include "widgets/models/map_text.h"

namespace leitstand {

/// "recorded", "registered again", "recorded (grey) and registered again".
[[nodiscard]] QString comparedMapText(ComparedMap which);

/// Returns the summary of one map of a comparison, for the title of its pane: "3D map · registered again · 13
/// key scans", and how far the scans moved.
[[nodiscard]] MapSummary comparedSummaryOf(const MapComparison& comparison, ComparedMap which);

}  // namespace leitstand
