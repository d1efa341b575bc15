#pragma once

#include <QPointF>

#include "widgets/map_view/camera/map_camera.h"
#include "widgets/models/map/map_view_settings.h"

namespace leitstand {

/// @p camera turned around its focus as if the map had been pulled by @p pixels; in a parallel view only
/// about z.
[[nodiscard]] MapCamera turned(MapCamera camera, const QPointF& pixels);

/// The camera shifted so that what lies at @p depth [m] follows a pull by @p pixels.
[[nodiscard]] MapCamera shifted(const MapProjection& projection, const QPointF& pixels, double depth);

/// The camera nearer (@p factor below 1) to or farther from the point at @p depth [m] under @p position,
/// which stays where it is on the screen.
[[nodiscard]] MapCamera zoomed(const MapProjection& projection, const QPointF& position, double depth,
                               double factor);

/// How @p preset looks at the map, not yet framed; the top look always looks straight down.
[[nodiscard]] MapCamera presetCamera(CameraPreset preset, MapLook look);

}  // namespace leitstand
