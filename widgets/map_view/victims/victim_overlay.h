#pragma once

#include <optional>
#include <vector>

#include "widgets/models/victims/victim_rows.h"

class QPainter;

namespace leitstand {

class MapProjection;
struct OverlayStyle;

/// Paints finds with their names, the selected one last and with a ring. Victims are discs, hazards diamonds,
/// codes squares, objects hexagons; filled if confirmed, otherwise outlined. Candidates are small dashed
/// rings with a question mark. A mark that another one would hide is moved aside, with a line to its place.
void paintVictims(QPainter& painter, const MapProjection& projection, const std::vector<VictimRow>& finds,
                  const std::optional<FindKey>& chosen, const OverlayStyle& style);

}  // namespace leitstand
