#pragma once

class QPainter;
class QRect;

namespace leitstand {

class MapProjection;
struct OverlayStyle;

/// Paints a scale bar of a round length beside the axes. The length holds at the depth of the camera's focus.
/// @p gridStep: distance of the grid's lines, also shown [m]; 0: no grid. Returns the area that the bar
/// covers.
QRect paintScaleBar(QPainter& painter, const MapProjection& projection, double gridStep,
                    const OverlayStyle& style);

/// Paints the directions of the map's axes x (red), y (green) and z (blue) in the bottom right corner.
void paintAxes(QPainter& painter, const MapProjection& projection, const OverlayStyle& style);

/// Returns the longest round length [m] that takes at most @p pixels at @p metresPerPixel.
[[nodiscard]] double roundLength(double metresPerPixel, double pixels);

}  // namespace leitstand
