#include "widgets/camera/camera_overlay.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <QCoreApplication>
#include <QPainterPath>
#include <QPolygonF>

#include "widgets/models/live/view_geometry.h"
#include "widgets/models/numbers.h"

namespace leitstand {
namespace {

struct OverlayTexts {
    Q_DECLARE_TR_FUNCTIONS(leitstand::CameraPane)
};

/// Pictures are dark or bright whatever the theme: what is drawn over them has the dark theme's colours.
const ThemeColours& inks() {
    return coloursOf(Theme::Dark);
}

const QColor Rim(0, 0, 0, 150);

/// Draws @p shape in @p colour with a dark rim.
void strokeRimmed(QPainter& painter, const QPainterPath& shape, const QColor& colour, double width,
                  Qt::PenStyle style = Qt::SolidLine) {
    painter.setBrush(Qt::NoBrush);
    QColor rim = Rim;
    rim.setAlpha(std::min(150, colour.alpha()));
    painter.setPen(QPen(rim, width + 2.0, style, Qt::FlatCap));
    painter.drawPath(shape);
    painter.setPen(QPen(colour, width, style, Qt::FlatCap));
    painter.drawPath(shape);
}

void paintMode(QPainter& painter, const QRectF& picture, double top, const ModeLabel& mode) {
    painter.save();
    const double room = std::min(0.6 * picture.width(), 320.0);
    painter.setFont(fitted(painter.font(), mode.text, room - 28.0, 18, 11));
    const QFontMetricsF metrics(painter.font());
    QRectF box(0, 0, metrics.horizontalAdvance(mode.text) + 28.0, metrics.height() + 10.0);
    box.moveCenter({picture.center().x(), 0.0});
    box.moveTop(std::max(picture.top(), top) + 8.0);
    paintModeSurface(painter, box, mode.kind, inks(), 4.0);
    painter.setPen(modeInk(mode.kind, inks()));
    painter.drawText(box, Qt::AlignCenter, mode.text);
    painter.restore();
}

void paintHorizon(QPainter& painter, const QRectF& picture, const CameraOverlay& overlay) {
    if (!overlay.roll || !overlay.pitch) return;
    const Horizon horizon =
        horizonOf(*overlay.roll, *overlay.pitch, overlay.pan.value_or(0.0), overlay.tilt.value_or(0.0));
    if (!horizon.visible) return;
    const double focal = 0.5 * picture.width() / std::tan(0.5 * std::clamp(overlay.viewAngle, 0.1, 2.8));
    const auto at = [&](double x) {
        return picture.center() + QPointF(x, focal * horizon.offset + horizon.slope * x);
    };
    const double half = 0.5 * picture.width();
    QPainterPath line;
    for (const auto& [from, to] : {std::pair(-0.62, -0.34), std::pair(0.34, 0.62)}) {
        line.moveTo(at(from * half));
        line.lineTo(at(to * half));
    }
    painter.save();
    painter.setClipRect(picture);
    strokeRimmed(painter, line, inks().select, 2.0);
    // where the camera looks
    QPainterPath cross;
    const QPointF middle = picture.center();
    const double arm = std::min(16.0, 0.03 * picture.width());
    cross.moveTo(middle - QPointF(arm, 0));
    cross.lineTo(middle + QPointF(arm, 0));
    cross.moveTo(middle - QPointF(0, arm));
    cross.lineTo(middle + QPointF(0, arm));
    strokeRimmed(painter, cross, QColor(255, 255, 255, 130), 1.0);
    painter.restore();
}

void paintRing(QPainter& painter, const QRectF& picture, const std::vector<Proximity>& ring) {
    if (ring.empty()) return;
    constexpr double Gap = 3.0;       // between parts [degrees]
    constexpr double SeenFrom = 2.5;  // farther things leave the ring faint [m]
    const double radius = 0.34 * std::min(picture.height(), picture.width());
    const QPointF centre(picture.center().x(), picture.top() + 0.58 * picture.height());
    const QRectF circle(centre.x() - radius, centre.y() - radius, 2.0 * radius, 2.0 * radius);
    const Proximity* nearest = nearestOf(ring);
    for (const Proximity& part : ring) {
        // ahead is up: directions are counter-clockwise from x, Qt's angles from the right
        const double from = inDegrees(part.from) + 90.0 + 0.5 * Gap;
        const double span = inDegrees(part.to - part.from) - Gap;
        QPainterPath arc;
        arc.arcMoveTo(circle, from);
        arc.arcTo(circle, from, span);
        switch (part.nearness) {
            case Nearness::Unknown:
                strokeRimmed(painter, arc, QColor(255, 255, 255, 110), 1.5, Qt::DotLine);
                break;
            case Nearness::Far: {
                const double near = std::clamp(1.0 - part.distance / SeenFrom, 0.0, 1.0);
                strokeRimmed(painter, arc, QColor(255, 255, 255, 60 + static_cast<int>(120.0 * near)), 4.0);
                break;
            }
            case Nearness::Near:
                strokeRimmed(painter, arc, inks().attention, 7.0);
                break;
            case Nearness::Touching:
                strokeRimmed(painter, arc, inks().act, 11.0);
                break;
        }
        const bool loud = part.nearness == Nearness::Near || part.nearness == Nearness::Touching;
        if (!loud && &part != nearest) continue;
        const double middle = 0.5 * (part.from + part.to);
        const QPointF at = centre + (radius - 30.0) * QPointF(-std::sin(middle), -std::cos(middle));
        QRectF box(0, 0, 90, 22);
        box.moveCenter(at);
        painter.save();
        painter.setFont(sized(painter.font(), loud ? 17 : 13, true));
        paintRimmedText(painter, box, Qt::AlignCenter,
                        OverlayTexts::tr("%1 m").arg(numberText(part.distance, 2)), Qt::white);
        painter.restore();
    }
}

QString panText(const CameraOverlay& overlay) {
    const auto degreesOf = [](double radians) {
        return numberText(std::abs(inDegrees(radians)), 0) + QChar(0xb0);
    };
    const auto small = [](double radians) { return std::abs(inDegrees(radians)) < 0.5; };
    QStringList parts;
    if (overlay.pan) {
        parts << (small(*overlay.pan)  ? OverlayTexts::tr("pan %1")
                  : *overlay.pan > 0.0 ? OverlayTexts::tr("pan %1 left")
                                       : OverlayTexts::tr("pan %1 right"))
                     .arg(degreesOf(*overlay.pan));
    }
    if (overlay.tilt && !small(*overlay.tilt)) {
        parts << (*overlay.tilt > 0.0 ? OverlayTexts::tr("%1 down") : OverlayTexts::tr("%1 up"))
                     .arg(degreesOf(*overlay.tilt));
    }
    if (!overlay.recentreKey.isEmpty()) parts << OverlayTexts::tr("%1 re-centres").arg(overlay.recentreKey);
    return parts.join(QStringLiteral(" · "));
}

void paintPan(QPainter& painter, const QRectF& picture, const CameraOverlay& overlay) {
    if (!overlay.pan && !overlay.tilt) return;
    const double pan = overlay.pan.value_or(0.0);
    const bool aside = overlay.moving && std::abs(pan) > degrees(10.0);
    const QColor colour = aside ? inks().attention : QColor(Qt::white);
    const double half = 0.29 * picture.width(), y = picture.bottom() - 14.0;
    const double x = picture.center().x();
    QPainterPath line;
    line.moveTo(x - half, y);
    line.lineTo(x + half, y);
    line.moveTo(x, y - 5.0);
    line.lineTo(x, y + 5.0);
    strokeRimmed(painter, line, QColor(255, 255, 255, 130), 1.5);
    const double limit = std::max(0.1, overlay.panLimit);
    const QPointF tip(x - half * std::clamp(pan / limit, -1.0, 1.0), y - 10.0);  // left is left
    QPolygonF mark;
    mark << tip << tip + QPointF(7, 12) << tip + QPointF(-7, 12);
    painter.setPen(QPen(Rim, 1.0));
    painter.setBrush(colour);
    painter.drawPolygon(mark);
    painter.save();
    painter.setFont(sized(painter.font(), 12));
    paintRimmedText(painter, QRectF(x - half, y - 32.0, 2.0 * half, 18.0), Qt::AlignCenter, panText(overlay),
                    colour);
    painter.restore();
}

}  // namespace

void paintRimmedText(QPainter& painter, const QRectF& box, int flags, const QString& text,
                     const QColor& colour) {
    painter.setPen(QColor(0, 0, 0, 190));
    for (const QPointF& step : {QPointF(-1, -1), QPointF(1, -1), QPointF(-1, 1), QPointF(1, 1)})
        painter.drawText(box.translated(step), flags, text);
    painter.setPen(colour);
    painter.drawText(box, flags, text);
}

void paintCameraOverlay(QPainter& painter, const QRectF& picture, double top, const CameraOverlay& overlay) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    paintHorizon(painter, picture, overlay);
    paintRing(painter, picture, overlay.ring);
    paintPan(painter, picture, overlay);
    if (overlay.mode) paintMode(painter, picture, top, *overlay.mode);
    painter.restore();
}

}  // namespace leitstand
