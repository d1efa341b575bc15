#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <QPainter>
#include <QString>

#include "widgets/map_view/gestures/ground_tools.h"
#include "widgets/map_view/map_ruler.h"
#include "widgets/map_view/map_view.h"
#include "widgets/map_view/overlays/floor/floor_overlay.h"
#include "widgets/map_view/overlays/floor/grid_overlay.h"
#include "widgets/map_view/overlays/overlay_style.h"
#include "widgets/models/map/robots/robot_marks.h"

namespace leitstand {

/// What MapView paints over the picture of the points: grid, marks, measurements, legend, scale and axes.
struct MapOverlay {
    std::vector<RobotMark> robots;
    std::vector<VictimRow> finds;
    std::optional<FindKey> chosenFind;
    FloorOverlay floor;
    GridOverlay grid;
    std::vector<Eigen::Vector2d> area;  ///< outlined on the floor, map frame [m]
    double ground = 0.0;                ///< height of the floor, map frame [m]
    QString hint;
    std::optional<Measurement> seam;
    std::vector<MapCaption> captions;
    std::vector<MapLink> links;
    std::uint64_t highlighted = 0;  ///< MapScan::id; 0: none
    GroundTools tools;
    MapRuler ruler;

    void paint(QPainter& painter, const MapProjection& projection, const SceneContent& content,
               const OverlayStyle& style);
    /// Returns the robot that is drawn at @p position; null: none.
    [[nodiscard]] const RobotMark* robotAt(const QPointF& position, const MapProjection& projection) const;
    [[nodiscard]] QString description() const;  ///< text for screen readers
};

}  // namespace leitstand
