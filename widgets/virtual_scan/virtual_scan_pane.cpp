#include "widgets/virtual_scan/virtual_scan_pane.h"

#include <algorithm>
#include <cmath>

#include <QKeyEvent>
#include <QWheelEvent>

#include "widgets/models/live/view_geometry.h"
#include "widgets/models/numbers.h"
#include "widgets/virtual_scan/virtual_scan_drawing.h"

namespace leitstand {
namespace {

constexpr double Lookahead = 3.0;  ///< of the predicted path [s]
constexpr double OriginAt = 0.66;  ///< share of the height below the head: more is seen ahead than behind
constexpr double ZoomStep = 1.15;  ///< per notch of the wheel
constexpr double AgeStep = 0.1;    ///< change of the age that repaints its text [s]

QRectF areaOf(const QWidget& pane) {
    return QRectF(pane.rect()).adjusted(6, paneHeadHeight(pane.font()), -4, -4);
}

}  // namespace

VirtualScanPane::VirtualScanPane(QWidget* parent) : QWidget(parent) {
    m_head.title = tr("Virtual scan");
    setFocusPolicy(Qt::TabFocus);
    setToolTip(
        tr("What is around the robot, its front up.\nYellow: walls. Dots: obstacles, fainter the longer "
           "ago they were seen.\nDashed: where it goes. The wheel, + and − zoom; a double click resets."));
    setAccessibleName(m_head.title);
}

void VirtualScanPane::setRobot(const RobotFace& face, const std::vector<Eigen::Vector2d>& footprint) {
    m_head.face = face;
    m_footprint = footprint;
    m_body = boxAround(footprint);
    m_view.reset();
    m_head.age = {};
    setAccessibleDescription(ageText(m_head.age));  // replaces that of the previous robot
    setAccessibleName(QStringLiteral("%1 · %2").arg(face.letter, m_head.title));
    update();
}

bool VirtualScanPane::shows(const std::optional<VirtualScanView>& view, const DriveVelocity& commanded,
                            double age) const {
    if (view.has_value() != m_view.has_value() || (view && view->at != m_view->at)) return false;
    const double before = m_head.age.arrival;
    return commanded == m_commanded && (age == before || std::abs(age - before) < AgeStep);
}

void VirtualScanPane::show(const std::optional<VirtualScanView>& view, const DriveVelocity& commanded,
                           double age) {
    if (shows(view, commanded, age)) return;
    m_view = view;
    m_commanded = commanded;
    m_head.age = {.arrival = age};
    const auto ring = view ? proximityRing(*view, m_body, commanded) : std::vector<Proximity>{};
    const Proximity* nearest = nearestOf(ring);
    setAccessibleDescription(nearest == nullptr
                                 ? ageText(m_head.age)
                                 : tr("nearest obstacle %1 m").arg(numberText(nearest->distance, 2)));
    update();
}

void VirtualScanPane::setRange(double metres) {
    m_range = std::clamp(metres, NearestRange, FarthestRange);
    update();
}

QPointF VirtualScanPane::pixelOf(const Eigen::Vector2d& point) const {
    const QRectF area = areaOf(*this);
    const double scale = OriginAt * area.height() / m_range;
    return QPointF(area.center().x(), area.top() + OriginAt * area.height()) -
           scale * QPointF(point.y(), point.x());
}

Eigen::Vector2d VirtualScanPane::pointOf(const QPointF& pixel) const {
    const QRectF area = areaOf(*this);
    const double scale = OriginAt * area.height() / m_range;
    const QPointF away = pixelOf(Eigen::Vector2d::Zero()) - pixel;
    return Eigen::Vector2d(away.y(), away.x()) / scale;
}

void VirtualScanPane::setLaserShown(bool shown) {
    m_laser = shown;
    update();
}

void VirtualScanPane::setPointing(bool pointing) {
    m_pointing = pointing;
    setCursor(pointing ? Qt::CrossCursor : Qt::ArrowCursor);
}

void VirtualScanPane::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    const ThemeColours& colours = coloursOf(presentTheme());
    painter.fillRect(rect(), colours.pane);
    painter.setRenderHint(QPainter::Antialiasing);
    const Freshness freshness = freshnessOf(m_head.age, m_head.limits);
    const QRectF area = areaOf(*this);
    const double scale = OriginAt * area.height() / m_range;
    const VirtualScanDrawing drawing(painter, colours, pixelOf(Eigen::Vector2d::Zero()), scale,
                                     freshness != Freshness::Live);
    painter.setClipRect(area.adjusted(0, 0, 4, 4));
    const QFont body = painter.font();
    painter.setFont(sized(body, 11));
    const bool seen = m_view && freshness != Freshness::Never;
    std::vector<Proximity> ring;
    if (seen && freshness != Freshness::Lost) ring = proximityRing(*m_view, m_body, m_commanded);
    const Proximity* nearest = nearestOf(ring);
    if (seen) drawing.surroundings(*m_view, m_laser);
    drawing.rings(area, m_range, nearest != nullptr ? drawing.nearestBox(*nearest, area) : QRectF());
    if (seen && freshness == Freshness::Live)
        drawing.path(predictedPath(m_body, m_commanded, Lookahead, &*m_view));
    drawing.robot(m_footprint, m_body);
    if (nearest != nullptr) drawing.nearest(*nearest, area);
    painter.setClipping(false);
    painter.setFont(body);
    paintLoss(painter, rect(), m_head, colours);
    paintPaneHead(painter, rect(), m_head, colours);
    if (hasFocus()) {
        painter.setPen(colours.select);
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(rect().adjusted(0, 0, -1, -1));
    }
}

void VirtualScanPane::wheelEvent(QWheelEvent* event) {
    setRange(m_range * std::pow(ZoomStep, -event->angleDelta().y() / 120.0));
    event->accept();
}

void VirtualScanPane::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Plus) {
        setRange(m_range / ZoomStep);
    } else if (event->key() == Qt::Key_Minus) {
        setRange(m_range * ZoomStep);
    } else {
        QWidget::keyPressEvent(event);
    }
}

void VirtualScanPane::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::RightButton && m_pointing) return emit pointingEnded();
    const bool points = m_pointing || event->modifiers().testFlag(Qt::ShiftModifier);
    if (event->button() == Qt::LeftButton && points && areaOf(*this).contains(event->position()))
        emit pointedAt(pointOf(event->position()));
}

void VirtualScanPane::mouseDoubleClickEvent(QMouseEvent* /*event*/) {
    setRange(UsualRange);
}

}  // namespace leitstand
