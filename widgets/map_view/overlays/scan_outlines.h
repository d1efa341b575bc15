#pragma once

class QPainter;

namespace leitstand {

class MapProjection;
struct OverlayStyle;
struct SceneContent;

/// Outlines each uncertain scan with a dashed line. While a scan is in question (SceneContent::inQuestion),
/// outlines only that one, with a strong solid line.
void paintScanOutlines(QPainter& painter, const MapProjection& projection, const SceneContent& content,
                       const OverlayStyle& style);

}  // namespace leitstand
