#include "widgets/camera/camera_overlay.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <QCoreApplication>
#include <QPainterPath>
#include <QPolygonF>

#include "core/event/station_samples.h"
#include "widgets/camera/pan_overlay.h"
#include "widgets/models/camera/mode_badge.h"
#include "widgets/models/camera/ring_layout.h"
#include "widgets/models/live/view_geometry.h"
#include "widgets/models/numbers.h"

namespace leitstand {
namespace {

struct OverlayTexts {
    Q_DECLARE_TR_FUNCTIONS(leitstand::CameraPane)
};

const QColor Rim(0, 0, 0, 150);

/// Paints the mode and returns its lower edge [px].
double paintMode(QPainter& painter, const QRectF& picture, double top, const ModeLabel& mode) {
    QRectF open = picture;
    open.setTop(std::max(picture.top(), top));
    const auto sizeOf = [&painter](const QString& text, int pixels) {
        const QFontMetricsF metrics(sized(painter.font(), pixels, true));
        return QSizeF(metrics.horizontalAdvance(text), metrics.height());
    };
    const ModeBadge badge = modeBadge(mode, open, sizeOf);
    if (badge.text.isEmpty()) return open.top();
    painter.save();
    painter.setFont(sized(painter.font(), badge.pixels, true));
    paintModeSurface(painter, badge.box, mode.kind, overlayInks(), 4.0);
    painter.setPen(modeInk(mode.kind, overlayInks()));
    painter.drawText(badge.box, Qt::AlignCenter, badge.text);
    painter.restore();
    return badge.box.bottom();
}

void paintHorizon(QPainter& painter, const QRectF& picture, const CameraOverlay& overlay) {
    if (!overlay.roll || !overlay.pitch) return;
    const Horizon horizon = horizonOf(*overlay.roll, *overlay.pitch, overlay.turn.pan.value_or(0.0),
                                      overlay.turn.tilt.value_or(0.0));
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
    strokeRimmed(painter, line, overlayInks().select, 2.0);
    // the cross marks where the camera looks
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

void paintArc(QPainter& painter, const QRectF& circle, const Proximity& part) {
    constexpr double Gap = 3.0;       // between parts [degrees]
    constexpr double SeenFrom = 2.5;  // things farther away are drawn faintest [m]
    // ahead is up: directions count counter-clockwise from x, Qt's angles from the right
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
            strokeRimmed(painter, arc, overlayInks().attention, 7.0);
            break;
        case Nearness::Touching:
            strokeRimmed(painter, arc, overlayInks().act, 11.0);
            break;
    }
}

void paintRing(QPainter& painter, const QRectF& circle, const std::vector<Proximity>& ring) {
    if (circle.isEmpty()) return;
    for (const Proximity& part : ring) paintArc(painter, circle, part);
    painter.save();
    const QFont loud = sized(painter.font(), 17, true), calm = sized(painter.font(), 13, true);
    const auto textOf = [](double distance) { return OverlayTexts::tr("%1 m").arg(numberText(distance, 2)); };
    const QFontMetricsF metrics(loud);
    const QSizeF size(metrics.horizontalAdvance(textOf(8.88)) + 4.0, metrics.height());
    for (const RingFigure& figure : ringFigures(ring, circle, size)) {
        QRectF box({0, 0}, size);
        box.moveCenter(figure.at);
        painter.setFont(figure.loud ? loud : calm);
        paintRimmedText(painter, box, Qt::AlignCenter, textOf(ring[figure.part].distance), Qt::white);
    }
    painter.restore();
}

void paintNotes(QPainter& painter, const QRectF& picture, double top, const QStringList& notes) {
    painter.save();
    painter.setFont(sized(painter.font(), 12, true));
    const QFontMetricsF metrics(painter.font());
    double y = std::max(picture.top(), top) + 8.0;
    for (const QString& note : notes) {
        const QRectF box(picture.left() + 8.0, y, metrics.horizontalAdvance(note) + 12.0,
                         metrics.height() + 4.0);
        painter.setPen(Qt::NoPen);
        painter.setBrush(QColor(0, 0, 0, 150));
        painter.drawRoundedRect(box, 3.0, 3.0);
        painter.setPen(overlayInks().select);
        painter.drawText(box, Qt::AlignCenter, note);
        y += box.height() + 3.0;
    }
    painter.restore();
}

/// Paints what detectors see: outlines, each with its text above it, or inside where there is no room above.
void paintDetections(QPainter& painter, const QRectF& picture, double top,
                     const std::vector<DetectionMark>& detections) {
    if (detections.empty()) return;
    painter.save();
    painter.setClipRect(picture);
    painter.setFont(sized(painter.font(), 13, true));
    const QFontMetricsF metrics(painter.font());
    for (const DetectionMark& mark : detections) {
        QPolygonF outline;
        for (const QPointF& corner : mark.corners)
            outline << picture.topLeft() +
                           QPointF(corner.x() * picture.width(), corner.y() * picture.height());
        QPainterPath path;
        path.addPolygon(outline);
        path.closeSubpath();
        strokeRimmed(painter, path, overlayInks().select, 2.0);
        if (mark.text.isEmpty()) continue;
        const QRectF around = outline.boundingRect();
        QRectF box(around.left(), around.top() - metrics.height() - 2.0,
                   metrics.horizontalAdvance(mark.text) + 4.0, metrics.height());
        if (box.top() < std::max(picture.top(), top)) box.moveTop(around.top() + 2.0);
        box.moveLeft(
            std::clamp(box.left(), picture.left(), std::max(picture.left(), picture.right() - box.width())));
        paintRimmedText(painter, box, Qt::AlignCenter, mark.text, overlayInks().select);
    }
    painter.restore();
}

}  // namespace

const ThemeColours& overlayInks() {
    return coloursOf(Theme::Dark);
}

void strokeRimmed(QPainter& painter, const QPainterPath& shape, const QColor& colour, double width,
                  Qt::PenStyle style) {
    painter.setBrush(Qt::NoBrush);
    QColor rim = Rim;
    rim.setAlpha(std::min(150, colour.alpha()));
    painter.setPen(QPen(rim, width + 2.0, style, Qt::FlatCap));
    painter.drawPath(shape);
    painter.setPen(QPen(colour, width, style, Qt::FlatCap));
    painter.drawPath(shape);
}

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
    paintDetections(painter, picture, top, overlay.detections);
    paintHorizon(painter, picture, overlay);
    double free = std::max(picture.top(), top);
    if (overlay.mode) free = paintMode(painter, picture, top, *overlay.mode);
    if (!overlay.ring.empty())
        paintRing(painter, ringCircle(picture, free, panWordsTop(picture, overlay)), overlay.ring);
    paintPan(painter, picture, overlay);
    // Beside the mode where there is room, below it otherwise.
    const bool beside = !overlay.mode || picture.width() >= 600.0;
    paintNotes(painter, picture, beside ? top : free, overlay.notes);
    painter.restore();
}

}  // namespace leitstand
