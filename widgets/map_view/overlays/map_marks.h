#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include <Eigen/Core>
#include <QString>

class QPainter;

namespace leitstand {

class MapProjection;
struct OverlayStyle;
struct SceneContent;

/// Paints lines 1 m apart (10 m if seen from afar) in the frame of the first scan, for the top view. Returns
/// their distance [m].
double paintGroundGrid(QPainter& painter, const MapProjection& projection, const SceneContent& content,
                       const OverlayStyle& style);

/// Marks the positions of visible scans: a blue square, or for an uncertain scan a hollow violet diamond with
/// a question mark. @p joined: also draws each robot's path.
void paintScanPositions(QPainter& painter, const MapProjection& projection, const SceneContent& content,
                        bool joined, const OverlayStyle& style);

/// Paints a ring around the position of scan @p id, and its number.
void paintHighlight(QPainter& painter, const MapProjection& projection, const SceneContent& content,
                    std::uint64_t id, const OverlayStyle& style);

/// Paints @p text above the one of @p places (map's frame [m]) that is highest on screen.
void paintCaption(QPainter& painter, const MapProjection& projection, std::span<const Eigen::Vector3d> places,
                  const QString& text, const OverlayStyle& style);

/// Paints the ends of a measurement, the line between them and its length. @p to: empty: not picked yet.
void paintMeasurement(QPainter& painter, const MapProjection& projection, const Eigen::Vector3d& from,
                      const std::optional<Eigen::Vector3d>& to, const OverlayStyle& style);

}  // namespace leitstand
