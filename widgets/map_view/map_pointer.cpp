#include "widgets/map_view/map_pointer.h"

#include <cmath>
#include <utility>

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include "widgets/map_view/camera/camera_moves.h"

namespace leitstand {
namespace {

constexpr double KeyStep = 40.0;        ///< distance that an arrow key pulls the map [px]
constexpr double ZoomPerNotch = 1.2;    ///< of a mouse wheel, and per press of + or −
constexpr double ZoomPerPixel = 1.005;  ///< of a drag

/// Returns the pull of an arrow key [px]; empty for other keys.
std::optional<QPointF> pullOf(int key) {
    switch (key) {
        case Qt::Key_Left:
            return QPointF(-KeyStep, 0);
        case Qt::Key_Right:
            return QPointF(KeyStep, 0);
        case Qt::Key_Up:
            return QPointF(0, -KeyStep);
        case Qt::Key_Down:
            return QPointF(0, KeyStep);
        default:
            return std::nullopt;
    }
}

}  // namespace

MapPointer::MapPointer(MapView& view, MapScenery& scenery, MapOverlay& overlay)
    : m_view(view), m_scenery(scenery), m_overlay(overlay) {
    m_hover.setSingleShot(true);
    m_hover.setInterval(HoverInterval);
    QObject::connect(&m_hover, &QTimer::timeout, &view,
                     [this] { emit m_view.hovered(m_view.pick(m_cursor)); });
}

MapPointer::Drag MapPointer::dragFor(const QMouseEvent& event, MapLook look) {
    if (event.button() == Qt::RightButton) return Drag::Zoom;
    if (event.button() == Qt::MiddleButton) return Drag::Shift;
    if (event.button() != Qt::LeftButton) return Drag::None;
    const bool shift = event.modifiers().testFlag(Qt::ShiftModifier) || look == MapLook::Top;
    return shift ? Drag::Shift : Drag::Turn;
}

double MapPointer::depthAt(const QPoint& position) const {
    const MapProjection projection = m_scenery.projection();
    const auto picked = m_view.pick(position);
    const auto projected = picked ? projection.project(picked->pointInMap) : std::nullopt;
    return projected ? projected->depth : projection.focusDepth();
}

void MapPointer::measureAt(const QPoint& position) {
    const auto picked = m_view.pick(position);
    if (!picked) return;
    const SceneContent& content = *m_scenery.picture().content;
    m_overlay.ruler.pick(*picked, content);
    if (const auto measurement = m_overlay.ruler.measurement(content)) emit m_view.measured(*measurement);
    m_view.update();
}

void MapPointer::moveBy(Drag how, const QPointF& pull) {
    const MapProjection projection(m_scenery.camera(), m_view.size());
    switch (how) {
        case Drag::Turn:
            m_scenery.moveCamera(turned(projection.camera(), pull));
            break;
        case Drag::Shift:
            if (m_scenery.following()) {
                m_scenery.stopFollowing();
                emit m_view.followEnded();
            }
            m_scenery.moveCamera(shifted(projection, pull, m_pressedDepth));
            break;
        case Drag::Zoom:
            m_scenery.moveCamera(
                zoomed(projection, QPointF(m_pressed), m_pressedDepth, std::pow(ZoomPerPixel, pull.y())));
            break;
        case Drag::None:
            break;
    }
}

void MapPointer::setMeasuring(bool on) {
    m_measuring = on;
    m_overlay.ruler.clear();
    m_view.setCursor(on ? Qt::CrossCursor : Qt::ArrowCursor);
    m_view.update();
}

void MapPointer::endGesture() {
    m_overlay.tools.end();
    m_view.setCursor(m_measuring ? Qt::CrossCursor : Qt::ArrowCursor);
    m_view.update();
}

bool MapPointer::drawing() const {
    return m_overlay.tools.posing() || m_overlay.tools.drawingArea() || m_overlay.tools.grabbing();
}

std::optional<Eigen::Vector3d> MapPointer::groundAt(const QPointF& position) const {
    const auto picked = m_view.pick(position.toPoint());
    if (picked && picked->label == Label::Floor) return picked->pointInMap;
    return groundUnder(m_scenery.projection(), position, m_overlay.ground);
}

bool MapPointer::pressGesture(const QMouseEvent& event) {
    if (!drawing()) return false;
    if (event.button() == Qt::RightButton) {
        if (m_overlay.tools.drawingArea()) {
            m_overlay.tools.takeCornerBack();
            m_view.update();
        } else {
            endGesture();
            emit m_view.gestureEnded();
        }
        return true;
    }
    if (event.button() != Qt::LeftButton) return false;  // the middle button still shifts the map
    if (m_overlay.tools.grabbing()) {
        const bool turns = event.modifiers().testFlag(Qt::ShiftModifier);
        if (const auto place = groundUnder(m_scenery.projection(), event.position(), m_overlay.ground))
            emit m_view.groundDragged(m_overlay.tools.grab(*place, turns));
        return true;
    }
    if (const auto place = groundAt(event.position())) {
        m_overlay.tools.press(*place, event.position());
        m_overlay.tools.addCorner(*place);
        m_view.update();
    }
    return true;
}

bool MapPointer::moveGesture(const QMouseEvent& event) {
    if (!drawing()) return false;
    if (m_overlay.tools.grabbing()) {
        const auto place = groundUnder(m_scenery.projection(), event.position(), m_overlay.ground);
        const auto dragged = place ? m_overlay.tools.dragTo(*place) : std::nullopt;
        if (dragged) emit m_view.groundDragged(*dragged);
        return true;
    }
    // While a heading is drawn, the ground's plane counts: picked points would make it jump.
    if (const auto place = event.buttons().testFlag(Qt::LeftButton)
                               ? groundUnder(m_scenery.projection(), event.position(), m_overlay.ground)
                               : groundAt(event.position())) {
        m_overlay.tools.moveTo(*place, event.position());
        m_view.update();
    }
    return true;
}

bool MapPointer::releaseGesture(const QMouseEvent& event) {
    if (!drawing()) return false;
    if (event.button() != Qt::LeftButton) return true;
    m_overlay.tools.letGo();
    if (const auto pose = m_overlay.tools.release()) {
        m_drawn = true;  // the second press of a double click is no new gesture
        emit m_view.poseDrawn(*pose);
    }
    m_view.update();
    return true;
}

void MapPointer::press(const QMouseEvent& event) {
    m_drawn = false;
    if (m_drag == Drag::None && pressGesture(event)) return;
    if (m_drag != Drag::None) return;  // a second button does not change the drag of the first
    m_drag = dragFor(event, m_view.settings().look);
    m_pressed = m_cursor = event.position().toPoint();
    m_pressedDepth = depthAt(m_pressed);
    m_dragged = false;
}

void MapPointer::move(const QMouseEvent& event) {
    const QPoint position = event.position().toPoint();
    if (m_drag == Drag::None && moveGesture(event)) return;
    if (m_drag == Drag::None) {
        m_cursor = position;
        if (!m_hover.isActive()) m_hover.start();
        return;
    }
    if (!m_dragged && (position - m_pressed).manhattanLength() < QApplication::startDragDistance()) {
        return;
    }
    m_dragged = true;
    const QPointF pull(position - m_cursor);
    m_cursor = position;
    moveBy(m_drag, pull);
}

void MapPointer::release(const QMouseEvent& event) {
    if (m_drag == Drag::None && releaseGesture(event)) return;
    if (event.buttons() != Qt::NoButton) return;
    m_drag = Drag::None;
    if (!m_dragged && m_measuring && event.button() == Qt::LeftButton) {
        measureAt(event.position().toPoint());
    }
}

void MapPointer::doubleClick(const QMouseEvent& event) {
    if (std::exchange(m_drawn, false)) return;
    if (event.button() != Qt::LeftButton || m_measuring || m_overlay.tools.posing() ||
        m_overlay.tools.grabbing()) {
        press(event);
        return;
    }
    if (m_overlay.tools.drawingArea()) {
        if (const auto area = m_overlay.tools.takeArea()) emit m_view.areaDrawn(*area);
        return;
    }
    if (const auto place = groundAt(event.position())) emit m_view.groundActivated(*place);
}

void MapPointer::roll(const QWheelEvent& event) {
    const double notches = event.angleDelta().y() / 120.0;
    const QPoint position = event.position().toPoint();
    const MapProjection projection(m_scenery.camera(), m_view.size());
    m_scenery.moveCamera(
        zoomed(projection, QPointF(position), depthAt(position), std::pow(ZoomPerNotch, -notches)));
}

bool MapPointer::pressKey(const QKeyEvent& event) {
    const MapProjection projection(m_scenery.camera(), m_view.size());
    const double depth = projection.focusDepth();
    const QPointF middle(m_view.width() / 2.0, m_view.height() / 2.0);
    if (const auto pull = pullOf(event.key())) {
        const bool shift = event.modifiers().testFlag(Qt::ShiftModifier);
        m_pressedDepth = depth;
        moveBy(shift ? Drag::Shift : Drag::Turn, *pull);
    } else if (event.key() == Qt::Key_Plus || event.key() == Qt::Key_Equal) {
        m_scenery.moveCamera(zoomed(projection, middle, depth, 1.0 / ZoomPerNotch));
    } else if (event.key() == Qt::Key_Minus) {
        m_scenery.moveCamera(zoomed(projection, middle, depth, ZoomPerNotch));
    } else if (event.key() == Qt::Key_Escape && m_overlay.ruler.begun()) {
        m_overlay.ruler.clear();
        m_view.update();
    } else {
        return false;
    }
    return true;
}

void MapPointer::leave() {
    m_hover.stop();
    emit m_view.hovered(std::nullopt);
}

}  // namespace leitstand
