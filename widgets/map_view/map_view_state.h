#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>

#include <QPoint>
#include <QTimer>

#include "widgets/map_view/gestures/ground_tools.h"
#include "widgets/map_view/map_ruler.h"
#include "widgets/map_view/map_scenery.h"
#include "widgets/map_view/map_view.h"
#include "widgets/map_view/overlays/floor_overlay.h"
#include "widgets/map_view/overlays/overlay_style.h"

namespace leitstand {

/// What the mouse does while a button is held.
enum class MapDrag : std::uint8_t { None, Turn, Shift, Zoom };

struct MapView::State {
    explicit State(MapView& mapView);

    [[nodiscard]] OverlayStyle style(Theme theme) const;
    /// Paints grid, marks, measurement, legend, scale and axes over the picture on screen.
    void paintOverlays(QPainter& painter);
    /// Returns the depth of the point drawn at @p position, or else of the camera's focus [m].
    [[nodiscard]] double depthAt(const QPoint& position) const;
    void measureAt(const QPoint& position);
    /// Returns the floor under @p position: scanned floor, else the ground's plane. In the map's frame [m].
    [[nodiscard]] std::optional<Eigen::Vector3d> groundAt(const QPointF& position) const;
    /// Returns the robot drawn at @p position; null: none.
    [[nodiscard]] const RobotMark* robotAt(const QPointF& position) const;
    void describe();  ///< updates the text for screen readers
    void showGhosts();
    void moveBy(MapDrag how, const QPointF& pull);
    /// Handle mouse events of gestures. False: no gesture is active and the camera gets the event.
    bool pressGesture(const QMouseEvent& event);
    bool moveGesture(const QMouseEvent& event);
    bool releaseGesture(const QMouseEvent& event);

    static constexpr std::chrono::milliseconds HoverInterval{50};

    MapView& view;
    MapScenery scenery;

    MapDrag drag = MapDrag::None;
    QPoint pressed, cursor;     ///< where the drag began, where the mouse is
    double pressedDepth = 0.0;  ///< of the point drawn there [m]
    bool dragged = false;       ///< moved farther than a click allows
    QTimer hover;               ///< limits how often hovering picks

    std::vector<RobotMark> robots;
    std::vector<VictimRow> finds;
    std::optional<FindKey> chosenFind;
    FloorOverlay floor;
    GroundTools tools;
    std::vector<Eigen::Vector2d> area;  ///< shown, map frame [m]
    double ground = 0.0;                ///< height of the floor, map frame [m]
    QString hint;
    std::optional<Measurement> seam;
    std::vector<MapCaption> captions;
    std::vector<MapLink> links;
    std::uint64_t highlighted = 0;
    std::map<std::uint64_t, Pose> ghosts, draggedScans;  ///< setGhosts(), setDragged()

    bool measuring = false;
    bool stale = false;  ///< the map is greyed
    bool drawn = false;  ///< a pose was drawn since the button was pressed
    MapRuler ruler;
};

}  // namespace leitstand
