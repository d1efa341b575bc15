#pragma once

#include <optional>

#include <QPointF>

namespace leitstand {

class MapProjection;
struct PickedPoint;
struct SceneContent;

/// Returns the point of @p content at @p position: the frontmost point drawn within 2 pixels, else within 4,
/// else within 8. Empty: none.
[[nodiscard]] std::optional<PickedPoint> pickPoint(const SceneContent& content,
                                                   const MapProjection& projection, const QPointF& position);

}  // namespace leitstand
