#pragma once

class QPainter;
class QRect;

namespace leitstand {

class MapProjection;
struct OverlayStyle;

/// A round length and how long it is on the screen at the camera's focus, beside the axes; @p gridStep: the
/// distance of the grid's lines [m], 0 without grid. Returns the place it took.
QRect paintScaleBar(QPainter& painter, const MapProjection& projection, double gridStep,
                    const OverlayStyle& style);

/// Which way x (red), y (green) and z (blue) of the map point, in the bottom right corner.
void paintAxes(QPainter& painter, const MapProjection& projection, const OverlayStyle& style);

/// The longest round length that takes at most @p pixels where one covers @p metresPerPixel [m].
[[nodiscard]] double roundLength(double metresPerPixel, double pixels);

}  // namespace leitstand
