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

/// Lines 1 m apart (10 m when seen from afar) in the first scan's frame, for the top view; returns their
/// distance [m].
double paintGroundGrid(QPainter& painter, const MapProjection& projection, const SceneContent& content,
                       const OverlayStyle& style);

/// Blue squares with a white edge where the visible scans were taken, hollow violet diamonds with a question
/// mark where they do not fit; @p joined: by each robot's way from scan to scan.
void paintScanPositions(QPainter& painter, const MapProjection& projection, const SceneContent& content,
                        bool joined, const OverlayStyle& style);

/// A ring around where the scan of this id was taken, and its number.
void paintHighlight(QPainter& painter, const MapProjection& projection, const SceneContent& content,
                    std::uint64_t id, const OverlayStyle& style);

/// @p text over that of @p places of the map which is highest on the screen.
void paintCaption(QPainter& painter, const MapProjection& projection, std::span<const Eigen::Vector3d> places,
                  const QString& text, const OverlayStyle& style);

/// The ends of a measurement, the line between them and its length; @p to may not be chosen yet.
void paintMeasurement(QPainter& painter, const MapProjection& projection, const Eigen::Vector3d& from,
                      const std::optional<Eigen::Vector3d>& to, const OverlayStyle& style);

}  // namespace leitstand
