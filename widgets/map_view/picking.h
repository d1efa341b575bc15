#pragma once

#include <optional>

#include <QPointF>

namespace leitstand {

class MapProjection;
struct PickedPoint;
struct SceneContent;

/// Returns the point of @p content drawn nearest to @p position. The frontmost point whose dot lies under it
/// wins; else the frontmost within 4 pixels, then within 8. Empty: none.
[[nodiscard]] std::optional<PickedPoint> pickPoint(const SceneContent& content,
                                                   const MapProjection& projection, const QPointF& position);

}  // namespace leitstand
