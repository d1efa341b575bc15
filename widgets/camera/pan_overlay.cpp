#include "widgets/camera/pan_overlay.h"

#include <algorithm>
#include <cmath>

#include <QPainterPath>
#include <QPolygonF>

#include "core/base/pose.h"
#include "widgets/camera/camera_overlay.h"
#include "widgets/models/numbers.h"

namespace leitstand {
namespace {

constexpr double WedgeBox = 56.0;     ///< side of the view from above [px]
constexpr double WordsHeight = 44.0;  ///< of the line with its words [px]
constexpr double LeastWidth = 320.0;  ///< narrower pictures show only the view from above [px]

const QColor& colourOf(const CameraOverlay& overlay) {
    static const QColor calm(Qt::white);
    const bool aside = overlay.moving && std::abs(overlay.turn.pan.value_or(0.0)) > degrees(10.0);
    return aside ? overlayInks().attention : calm;
}

/// Paints the body from above, ahead up, and the camera's field of view.
void paintFromAbove(QPainter& painter, const QRectF& box, const CameraOverlay& overlay,
                    const QColor& colour) {
    const QPointF eye(box.center().x(), box.center().y() + 4.0);
    const double pan = inDegrees(overlay.turn.pan.value_or(0.0));
    const double span = std::clamp(inDegrees(overlay.viewAngle), 6.0, 180.0);
    const double reach = 0.5 * box.width() - 2.0;
    QPainterPath wedge(eye);
    wedge.arcTo({eye.x() - reach, eye.y() - reach, 2.0 * reach, 2.0 * reach}, 90.0 + pan - 0.5 * span, span);
    wedge.closeSubpath();
    QColor veil = colour;
    veil.setAlpha(90);
    painter.setPen(QPen(QColor(0, 0, 0, 150), 3.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(wedge);
    painter.setPen(QPen(colour, 1.5));
    painter.setBrush(veil);
    painter.drawPath(wedge);
    // the body, with a notch at its front
    const QRectF body(eye.x() - 6.0, eye.y() - 3.0, 12.0, 17.0);
    painter.setPen(QPen(QColor(0, 0, 0, 150), 1.0));
    painter.setBrush(QColor(255, 255, 255, 190));
    painter.drawRoundedRect(body, 2.0, 2.0);
    painter.setPen(QPen(QColor(0, 0, 0, 190), 1.5));
    painter.drawLine(QPointF(body.left() + 3.0, body.top() + 3.0),
                     QPointF(body.right() - 3.0, body.top() + 3.0));
}

void paintMark(QPainter& painter, const QPointF& tip, const QColor& colour, bool filled) {
    QPolygonF mark;
    mark << tip << tip + QPointF(7, 12) << tip + QPointF(-7, 12);
    painter.setPen(filled ? QPen(QColor(0, 0, 0, 150), 1.0) : QPen(colour, 1.5));
    painter.setBrush(filled ? QBrush(colour) : QBrush(Qt::NoBrush));
    painter.drawPolygon(mark);
}

void paintLine(QPainter& painter, const QRectF& picture, const CameraOverlay& overlay, const QColor& colour) {
    const double half = 0.29 * picture.width(), y = picture.bottom() - 14.0;
    const double x = picture.center().x();
    QPainterPath line;
    line.moveTo(x - half, y);
    line.lineTo(x + half, y);
    line.moveTo(x, y - 5.0);
    line.lineTo(x, y + 5.0);
    strokeRimmed(painter, line, QColor(255, 255, 255, 130), 1.5);
    const double limit = std::max(0.1, overlay.panLimit);
    const auto tipOf = [&](double pan) {  // positive pan is left
        return QPointF(x - half * std::clamp(pan / limit, -1.0, 1.0), y - 10.0);
    };
    if (overlay.requestedPan) paintMark(painter, tipOf(*overlay.requestedPan), overlayInks().select, false);
    paintMark(painter, tipOf(overlay.turn.pan.value_or(0.0)), colour, true);
}

void paintWords(QPainter& painter, const QRectF& picture, const CameraOverlay& overlay,
                const QColor& colour) {
    painter.save();
    painter.setFont(sized(painter.font(), 12));
    const QFontMetricsF metrics(painter.font());
    const double room = picture.width() - 2.0 * (WedgeBox + 14.0);
    QString words = panText(overlay.turn);
    if (metrics.horizontalAdvance(words) > room) words = shortPanText(overlay.turn);
    if (metrics.horizontalAdvance(words) <= room) {
        const QRectF box(picture.center().x() - 0.5 * room, picture.bottom() - WordsHeight, room, 18.0);
        paintRimmedText(painter, box, Qt::AlignCenter, words, colour);
    }
    painter.restore();
}

}  // namespace

QRectF panMarkArea(const QRectF& picture) {
    return {picture.left() + 8.0, picture.bottom() - WedgeBox - 6.0, WedgeBox, WedgeBox};
}

double panWordsTop(const QRectF& picture, const CameraOverlay& overlay) {
    const bool words = (overlay.turn.pan || overlay.turn.tilt) && picture.width() >= LeastWidth;
    return words ? picture.bottom() - WordsHeight : picture.bottom();
}

void paintPan(QPainter& painter, const QRectF& picture, const CameraOverlay& overlay) {
    if (!overlay.turn.pan && !overlay.turn.tilt) return;
    const QColor colour = colourOf(overlay);
    paintFromAbove(painter, panMarkArea(picture), overlay, colour);
    if (picture.width() < LeastWidth) return;
    paintLine(painter, picture, overlay, colour);
    paintWords(painter, picture, overlay, colour);
}

}  // namespace leitstand
