#pragma once

class QPainter;

namespace leitstand {

class MapProjection;
struct OverlayStyle;
struct SceneContent;

/// A line around each uncertain scan as it is seen: dashed while it waits, a strong one around the one that
/// is decided on.
void paintScanOutlines(QPainter& painter, const MapProjection& projection, const SceneContent& content,
                       const OverlayStyle& style);

}  // namespace leitstand
