#pragma once

#include <optional>

#include <Eigen/Core>

class QPainter;

namespace leitstand {

class MapProjection;
struct OverlayStyle;
struct SceneContent;

/// Lines 1 m apart (10 m when seen from afar) in the first scan's frame, for the top view; returns their
/// distance [m].
double paintGroundGrid(QPainter& painter, const MapProjection& projection, const SceneContent& content,
                       const OverlayStyle& style);

/// Blue squares with a white edge where the visible scans were taken, joined by the robot's trail.
void paintScanPositions(QPainter& painter, const MapProjection& projection, const SceneContent& content,
                        const OverlayStyle& style);

/// The ends of a measurement, the line between them and its length; @p to may not be chosen yet.
void paintMeasurement(QPainter& painter, const MapProjection& projection, const Eigen::Vector3d& from,
                      const std::optional<Eigen::Vector3d>& to, const OverlayStyle& style);

}  // namespace leitstand
