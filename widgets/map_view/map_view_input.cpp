#include <cmath>

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include "widgets/map_view/camera/camera_moves.h"
#include "widgets/map_view/map_view_state.h"

namespace leitstand {
namespace {

constexpr double KeyStep = 40.0;        ///< distance that an arrow key pulls the map [px]
constexpr double ZoomPerNotch = 1.2;    ///< of a mouse wheel, and per press of + or −
constexpr double ZoomPerPixel = 1.005;  ///< of a drag

MapDrag dragFor(const QMouseEvent& event, MapLook look) {
    if (event.button() == Qt::RightButton) return MapDrag::Zoom;
    if (event.button() == Qt::MiddleButton) return MapDrag::Shift;
    if (event.button() != Qt::LeftButton) return MapDrag::None;
    const bool shift = event.modifiers().testFlag(Qt::ShiftModifier) || look == MapLook::Top;
    return shift ? MapDrag::Shift : MapDrag::Turn;
}

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

double MapView::State::depthAt(const QPoint& position) const {
    const MapProjection projection = scenery.projection();
    const auto picked = view.pick(position);
    const auto projected = picked ? projection.project(picked->pointInMap) : std::nullopt;
    return projected ? projected->depth : projection.focusDepth();
}

void MapView::State::measureAt(const QPoint& position) {
    const auto picked = view.pick(position);
    if (!picked) return;
    const SceneContent& content = *scenery.picture().content;
    ruler.pick(*picked, content);
    if (const auto measurement = ruler.measurement(content)) emit view.measured(*measurement);
    view.update();
}

void MapView::State::moveBy(MapDrag how, const QPointF& pull) {
    const MapProjection projection(scenery.camera(), view.size());
    switch (how) {
        case MapDrag::Turn:
            scenery.moveCamera(turned(projection.camera(), pull));
            break;
        case MapDrag::Shift:
            if (scenery.following()) {
                scenery.stopFollowing();
                emit view.followEnded();
            }
            scenery.moveCamera(shifted(projection, pull, pressedDepth));
            break;
        case MapDrag::Zoom:
            scenery.moveCamera(
                zoomed(projection, QPointF(pressed), pressedDepth, std::pow(ZoomPerPixel, pull.y())));
            break;
        case MapDrag::None:
            break;
    }
}

void MapView::mousePressEvent(QMouseEvent* event) {
    State& state = *m_state;
    state.drawn = false;
    if (state.drag == MapDrag::None && state.pressGesture(*event)) return;
    if (state.drag != MapDrag::None) return;  // a second button does not change the drag of the first
    state.drag = dragFor(*event, settings().look);
    state.pressed = state.cursor = event->position().toPoint();
    state.pressedDepth = state.depthAt(state.pressed);
    state.dragged = false;
}

void MapView::mouseMoveEvent(QMouseEvent* event) {
    State& state = *m_state;
    const QPoint position = event->position().toPoint();
    if (state.drag == MapDrag::None && state.moveGesture(*event)) return;
    if (state.drag == MapDrag::None) {
        state.cursor = position;
        if (!state.hover.isActive()) state.hover.start();
        return;
    }
    if (!state.dragged && (position - state.pressed).manhattanLength() < QApplication::startDragDistance()) {
        return;
    }
    state.dragged = true;
    const QPointF pull(position - state.cursor);
    state.cursor = position;
    state.moveBy(state.drag, pull);
}

void MapView::mouseReleaseEvent(QMouseEvent* event) {
    State& state = *m_state;
    if (state.drag == MapDrag::None && state.releaseGesture(*event)) return;
    if (event->buttons() != Qt::NoButton) return;
    state.drag = MapDrag::None;
    if (!state.dragged && state.measuring && event->button() == Qt::LeftButton) {
        state.measureAt(event->position().toPoint());
    }
}

void MapView::wheelEvent(QWheelEvent* event) {
    const double notches = event->angleDelta().y() / 120.0;
    const QPoint position = event->position().toPoint();
    const MapProjection projection(m_state->scenery.camera(), size());
    m_state->scenery.moveCamera(
        zoomed(projection, QPointF(position), m_state->depthAt(position), std::pow(ZoomPerNotch, -notches)));
    event->accept();
}

void MapView::keyPressEvent(QKeyEvent* event) {
    State& state = *m_state;
    const MapProjection projection(state.scenery.camera(), size());
    const double depth = projection.focusDepth();
    const QPointF middle(width() / 2.0, height() / 2.0);
    if (const auto pull = pullOf(event->key())) {
        const bool shift = event->modifiers().testFlag(Qt::ShiftModifier);
        state.pressedDepth = depth;
        state.moveBy(shift ? MapDrag::Shift : MapDrag::Turn, *pull);
    } else if (event->key() == Qt::Key_Plus || event->key() == Qt::Key_Equal) {
        state.scenery.moveCamera(zoomed(projection, middle, depth, 1.0 / ZoomPerNotch));
    } else if (event->key() == Qt::Key_Minus) {
        state.scenery.moveCamera(zoomed(projection, middle, depth, ZoomPerNotch));
    } else if (event->key() == Qt::Key_Escape && state.ruler.begun()) {
        state.ruler.clear();
        update();
    } else {
        event->ignore();
    }
}

void MapView::leaveEvent(QEvent* event) {
    QWidget::leaveEvent(event);
    m_state->hover.stop();
    emit hovered(std::nullopt);
}

}  // namespace leitstand
