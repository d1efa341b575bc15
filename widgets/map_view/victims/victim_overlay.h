#pragma once

#include <optional>
#include <vector>

#include "widgets/models/victims/victim_rows.h"

class QPainter;

namespace leitstand {

class MapProjection;
struct OverlayStyle;

/// Paints finds with their names, the chosen one last and ringed. Victims are discs, hazards diamonds, codes
/// squares, objects hexagons; filled when confirmed, else outlined. Candidates are small dashed rings with a
/// question mark. A mark that another one would hide moves aside, with a line to its place.
void paintVictims(QPainter& painter, const MapProjection& projection, const std::vector<VictimRow>& finds,
                  const std::optional<FindKey>& chosen, const OverlayStyle& style);

}  // namespace leitstand
