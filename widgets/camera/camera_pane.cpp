#include "widgets/camera/camera_pane.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QApplication>
#include <QMouseEvent>

#include "widgets/camera/camera_overlay.h"
#include "widgets/camera/omni_overlay.h"
#include "widgets/camera/pan_overlay.h"
#include "widgets/camera/thermal_overlay.h"
#include "widgets/models/numbers.h"

namespace leitstand {
namespace {

constexpr double Rhythm = 0.1;  ///< a picture younger than this is soon followed by the next [s]

}  // namespace

CameraPane::CameraPane(QWidget* parent) : QWidget(parent) {
    setMouseTracking(true);
    setToolTip(
        tr("The ring tells how near things are: faint is far, dots are unknown, amber near, thick "
           "red-orange at the body.\nThe blue line is the horizon."));
}

void CameraPane::setCamera(const RobotFace& face, const QString& title) {
    if (m_head.face == face && m_head.title == title) return;
    m_head.face = face;
    m_head.title = title;
    m_head.age = {};
    m_picture = m_scaled = {};
    m_thermal.reset();
    m_heat.clear();
    m_overlay = {};
    m_panorama.reset();
    m_front.reset();
    m_pressed.reset();
    setTurnable(false);
    setAccessibleName(QStringLiteral("%1 · %2").arg(face.letter, title));
    update();
}

void CameraPane::setPicture(const QImage& picture) {
    m_picture = picture;
    m_scaled = {};
    m_thermal.reset();
    m_heat.clear();
    update();
}

void CameraPane::setVacant(bool vacant) {
    if (std::exchange(m_head.vacant, vacant) != vacant) update();
}

void CameraPane::setThermal(std::shared_ptr<const ThermalPicture> picture, const ThermalRange& range,
                            ThermalPalette palette) {
    m_picture = picture ? imageOf(*picture, range, palette) : QImage();
    m_scaled = {};
    m_thermal = std::move(picture);
    m_thermalRange = range;
    m_palette = palette;
    update();
}

void CameraPane::setHeat(const std::vector<HeatBlob>& blobs) {
    m_heat = blobs;
    update();
}

void CameraPane::setAge(const DataAge& age, const QString& note) {
    const bool sameLook = lossText(m_head.age, m_head.limits) == lossText(age, m_head.limits) &&
                          freshnessOf(m_head.age, m_head.limits) == freshnessOf(age, m_head.limits);
    m_head.age = age;
    m_head.note = note;
    setAccessibleDescription(ageText(age, m_head.limits));
    if (sameLook && nextIsNear()) return;
    if (sameLook) {
        update(0, 0, width(), paneHeadHeight(font()));
    } else {
        update();
    }
}

void CameraPane::setOverlay(const CameraOverlay& overlay) {
    m_overlay = overlay;
    if (!nextIsNear()) update();
}

bool CameraPane::nextIsNear() const {
    return !m_picture.isNull() && m_head.age.arrival < Rhythm;
}

void CameraPane::setPanorama(const std::optional<PanoramaShape>& shape) {
    if (m_panorama == shape) return;
    m_panorama = shape;
    update();
}

void CameraPane::setFront(const std::optional<QPointF>& ahead) {
    if (m_front == ahead) return;
    m_front = ahead;
    update();
}

void CameraPane::setTurnable(bool turnable) {
    if (m_turnable == turnable) return;
    m_turnable = turnable;
    m_dragging = false;
    showCursor();
}

void CameraPane::setPointing(bool pointing) {
    m_pointing = pointing;
    m_pressed.reset();
    m_dragging = false;
    showCursor();
}

void CameraPane::showCursor() {
    setCursor(m_pointing ? Qt::CrossCursor : m_turnable ? Qt::OpenHandCursor : Qt::ArrowCursor);
}

QRectF CameraPane::pictureArea() const {
    if (m_picture.isNull()) return {};
    if (m_panorama) {  // wide and low: the overlay goes below it
        const double top = std::min<double>(paneHeadHeight(font()), 0.5 * height());
        const QSizeF size =
            QSizeF(m_picture.size()).scaled(QSizeF(width(), height() - top), Qt::KeepAspectRatio);
        return {0.5 * (width() - size.width()), top, size.width(), size.height()};
    }
    const QSizeF size = QSizeF(m_picture.size()).scaled(QSizeF(this->size()), Qt::KeepAspectRatio);
    return {0.5 * (width() - size.width()), 0.5 * (height() - size.height()), size.width(), size.height()};
}

QPointF CameraPane::inPicture(const QPointF& pixel) const {
    const QRectF area = pictureArea();
    if (area.isEmpty()) return {-1.0, -1.0};
    return {(pixel.x() - area.left()) / area.width(), (pixel.y() - area.top()) / area.height()};
}

void CameraPane::scalePicture(const QSize& size, bool grey) {
    if (m_scaled.size() == size && m_scaledGrey == grey) return;
    QImage scaled(size, QImage::Format_RGB32);
    QPainter painter(&scaled);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(QRect({0, 0}, size),
                      grey ? m_picture.convertToFormat(QImage::Format_Grayscale8) : m_picture);
    painter.end();
    m_scaled = std::move(scaled);
    m_scaledGrey = grey;
}

void CameraPane::paintPicture(QPainter& painter, Freshness freshness) {
    if (m_picture.isNull() || freshness == Freshness::Never) return;
    // Scaled once per picture: the overlay changes more often.
    const double ratio = painter.device()->devicePixelRatioF();
    const QRectF area = pictureArea();
    scalePicture((ratio * area.size()).toSize().expandedTo({1, 1}), freshness != Freshness::Live);
    m_scaled.setDevicePixelRatio(ratio);
    painter.setOpacity(freshness == Freshness::Live ? 1.0 : freshness == Freshness::Stale ? 0.55 : 0.15);
    painter.drawImage((area.topLeft() * ratio).toPoint() / ratio, m_scaled);
    painter.setOpacity(1.0);
}

void CameraPane::paintThermal(QPainter& painter, bool live) const {
    const QRectF area = pictureArea();
    const QRectF open = area.adjusted(0, std::max(0.0, paneHeadHeight(font()) - area.top()), 0, 0);
    std::vector<QRectF> taken;
    if (live) taken.push_back(thermalScaleArea(open));
    if (m_overlay.turn.pan || m_overlay.turn.tilt) taken.push_back(panMarkArea(area));
    paintHeat(painter, area, *m_thermal, m_heat, open, taken);
    if (!live) return;  // a grey picture shows no temperatures
    paintThermalScale(painter, open, m_thermalRange, m_palette);
    if (!m_pointer) return;
    const QPointF at = inPicture(*m_pointer);
    if (const auto celsius = celsiusAt(*m_thermal, at.x(), at.y()))
        paintCelsius(painter, open, *m_pointer, *celsius);
}

QRectF CameraPane::overlayArea() const {
    if (m_picture.isNull()) return rect();
    const QRectF area = pictureArea();
    return m_panorama ? QRectF(0, area.bottom(), width(), height() - area.bottom()) : area;
}

void CameraPane::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    const ThemeColours& colours = coloursOf(presentTheme());
    // Dark in every theme: overlays are made for it.
    painter.fillRect(rect(), coloursOf(Theme::Dark).pane);
    const Freshness freshness = freshnessOf(m_head.age, m_head.limits);
    paintPicture(painter, freshness);
    const bool seen = freshness == Freshness::Live || freshness == Freshness::Stale;
    if (seen && m_thermal) paintThermal(painter, freshness == Freshness::Live);
    if (seen && m_panorama) paintPanorama(painter, pictureArea(), *m_panorama);
    if (seen && m_front && !m_panorama) paintFront(painter, pictureArea(), *m_front);
    // Mode, horizon and proximity have ages of their own: they stay when pictures do not come.
    paintCameraOverlay(painter, overlayArea(), paneHeadHeight(font()), m_overlay);
    paintLoss(painter, rect(), m_head, colours);
    paintPaneHead(painter, rect(), m_head, colours);
}

void CameraPane::mouseMoveEvent(QMouseEvent* event) {
    m_pointer = event->position();
    if (m_thermal) update();
    if (!m_pressed || !m_turnable) return;
    const bool far = (event->position() - *m_pressed).manhattanLength() >= QApplication::startDragDistance();
    if (!m_dragging && !far) return;
    const bool first = !std::exchange(m_dragging, true);
    if (first) setCursor(Qt::ClosedHandCursor);
    emit pictureDragged(inPicture(*m_pressed), inPicture(event->position()), first);
}

void CameraPane::leaveEvent(QEvent* /*event*/) {
    m_pointer.reset();
    update();
}

void CameraPane::mousePressEvent(QMouseEvent* event) {
    const QPointF at = inPicture(event->position());
    const bool inside = at.x() >= 0.0 && at.x() < 1.0 && at.y() >= 0.0 && at.y() < 1.0;
    if (event->button() == Qt::RightButton && m_pointing) return emit pointingEnded();
    if (event->button() != Qt::LeftButton || !inside) return;
    if (m_pointing) return emit pointedAt(at);
    m_pressed = event->position();
    m_points = event->modifiers().testFlag(Qt::ShiftModifier);  // unless dragged: Shift also drives slowly
}

void CameraPane::mouseDoubleClickEvent(QMouseEvent* event) {
    event->accept();  // the first click was handled; its double click must not drive
}

void CameraPane::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || !m_pressed) return;
    const QPointF at = inPicture(*std::exchange(m_pressed, std::nullopt));
    if (std::exchange(m_dragging, false)) {
        showCursor();
    } else if (m_points) {
        emit pointedAt(at);
    } else {
        emit pictureClicked(at.x(), at.y());
    }
}

}  // namespace leitstand
