#pragma once

#include <QPointF>

#include "widgets/map_view/camera/map_camera.h"
#include "widgets/models/map/map_view_settings.h"

namespace leitstand {

/// Returns @p camera turned around its focus as if the map were dragged by @p pixels. A parallel view only
/// turns about z.
[[nodiscard]] MapCamera turned(MapCamera camera, const QPointF& pixels);

/// Returns the camera shifted so that points at @p depth [m] follow a drag by @p pixels.
[[nodiscard]] MapCamera shifted(const MapProjection& projection, const QPointF& pixels, double depth);

/// Returns the camera moved nearer to the point at @p depth [m] under @p position (@p factor below 1), or
/// farther from it. That point stays at the same place on the screen.
[[nodiscard]] MapCamera zoomed(const MapProjection& projection, const QPointF& position, double depth,
                               double factor);

/// Returns the camera of @p preset, before the map is framed. The top look always looks straight down.
[[nodiscard]] MapCamera presetCamera(CameraPreset preset, MapLook look);

}  // namespace leitstand
