#pragma once

class QPainter;

namespace leitstand {

class MapProjection;
struct OverlayStyle;
struct SceneContent;

/// Outlines each uncertain scan with a dashed line. While there is a question about a scan
/// (SceneContent::inQuestion), outlines only that scan, with a strong solid line.
void paintScanOutlines(QPainter& painter, const MapProjection& projection, const SceneContent& content,
                       const OverlayStyle& style);

}  // namespace leitstand
