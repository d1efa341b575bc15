#pragma once

class QPainter;

namespace leitstand {

class MapProjection;
struct OverlayStyle;
struct SceneContent;

/// Outlines each uncertain scan on screen: dashed while it waits, with a strong line around the one in
/// question.
void paintScanOutlines(QPainter& painter, const MapProjection& projection, const SceneContent& content,
                       const OverlayStyle& style);

}  // namespace leitstand
