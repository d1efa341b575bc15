#pragma once

class QPainter;
class QRect;

namespace leitstand {

class MapProjection;
struct OverlayStyle;

/// Paints a scale bar of a round length beside the axes. The length is valid at the depth of the camera's
/// focus. @p gridStep: distance of the grid's lines, shown as well [m]; 0: no grid. Returns the area of the
/// bar.
QRect paintScaleBar(QPainter& painter, const MapProjection& projection, double gridStep,
                    const OverlayStyle& style);

/// Paints the directions of the map's axes x (red), y (green) and z (blue) in the bottom right corner.
void paintAxes(QPainter& painter, const MapProjection& projection, const OverlayStyle& style);

/// Returns the longest round length [m] that takes at most @p pixels pixels. @p metresPerPixel: scale.
[[nodiscard]] double roundLength(double metresPerPixel, double pixels);

}  // namespace leitstand
