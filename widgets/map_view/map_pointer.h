#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

#include <QPoint>
#include <QTimer>

#include "widgets/map_view/map_overlay.h"
#include "widgets/map_view/map_scenery.h"
#include "widgets/map_view/map_view.h"

namespace leitstand {

/// What the mouse and the keys do in a MapView: move its camera, draw on its floor, and measure. Emits the
/// view's signals.
class MapPointer {
public:
    MapPointer(MapView& view, MapScenery& scenery, MapOverlay& overlay);

    void press(const QMouseEvent& event);
    void move(const QMouseEvent& event);
    void release(const QMouseEvent& event);
    void doubleClick(const QMouseEvent& event);
    void roll(const QWheelEvent& event);
    [[nodiscard]] bool pressKey(const QKeyEvent& event);  ///< false: the key has no meaning here
    void leave();

    void setMeasuring(bool on);
    void endGesture();
    [[nodiscard]] bool drawing() const;  ///< whether a gesture is active

private:
    /// What the mouse does while a button is held.
    enum class Drag : std::uint8_t { None, Turn, Shift, Zoom };
    static constexpr std::chrono::milliseconds HoverInterval{50};

    [[nodiscard]] static Drag dragFor(const QMouseEvent& event, MapLook look);
    /// Returns the depth of the point drawn at @p position [m]. If there is none, returns that of the
    /// camera's focus.
    [[nodiscard]] double depthAt(const QPoint& position) const;
    void measureAt(const QPoint& position);
    /// Returns the floor under @p position in the map's frame [m]: scanned floor, otherwise the plane of the
    /// ground.
    [[nodiscard]] std::optional<Eigen::Vector3d> groundAt(const QPointF& position) const;
    void moveBy(Drag how, const QPointF& pull);
    /// Handle mouse events of gestures. False: no gesture is active, so the camera gets the event.
    bool pressGesture(const QMouseEvent& event);
    bool moveGesture(const QMouseEvent& event);
    bool releaseGesture(const QMouseEvent& event);

    MapView& m_view;
    MapScenery& m_scenery;
    MapOverlay& m_overlay;
    Drag m_drag = Drag::None;
    QPoint m_pressed, m_cursor;   ///< where the drag began; where the mouse is now
    double m_pressedDepth = 0.0;  ///< depth of the point drawn at m_pressed [m]
    bool m_dragged = false;       ///< whether the mouse moved farther than a click allows
    bool m_drawn = false;         ///< whether a pose was drawn since the button was pressed
    bool m_measuring = false;
    QTimer m_hover;  ///< limits how often hovering picks
};

}  // namespace leitstand
