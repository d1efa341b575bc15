#pragma once

#include <optional>

#include <QPointF>

namespace leitstand {

class MapProjection;
struct PickedPoint;
struct SceneContent;

/// The point of @p content drawn nearest to @p position: of the points whose dots lie under it the frontmost;
/// if there is none, the frontmost of those within 4 pixels, then within 8.
[[nodiscard]] std::optional<PickedPoint> pickPoint(const SceneContent& content,
                                                   const MapProjection& projection, const QPointF& position);

}  // namespace leitstand
