#pragma once

#include <optional>

#include <QPointF>

namespace leitstand {

class MapProjection;
struct PickedPoint;
struct SceneContent;

/// Returns the point of @p content at @p position: the frontmost point that is drawn within 2 pixels; if
/// there is none, within 4, then within 8. Empty: none.
[[nodiscard]] std::optional<PickedPoint> pickPoint(const SceneContent& content,
                                                   const MapProjection& projection, const QPointF& position);

}  // namespace leitstand
