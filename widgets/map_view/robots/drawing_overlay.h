#pragma once

#include <vector>

class QPainter;

namespace leitstand {

class MapProjection;
struct OverlayStyle;
struct RobotMark;

/// Paints what robots draw: lines, dots and texts in the colours that they give them, with a rim that is seen
/// on every ground.
void paintDrawings(QPainter& painter, const MapProjection& projection, const std::vector<RobotMark>& robots,
                   const OverlayStyle& style);

}  // namespace leitstand
