#include "widgets/camera/omni_overlay.h"

#include <algorithm>

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QLineF>
#include <QPainterPath>
#include <QPolygonF>

#include "widgets/camera/camera_overlay.h"
#include "widgets/models/camera/camera_text.h"
#include "widgets/painting/pane_paint.h"

namespace leitstand {
namespace {

struct OmniTexts {
    Q_DECLARE_TR_FUNCTIONS(leitstand::CameraPane)
};

const QColor Faint(255, 255, 255, 130);

void paintArrow(QPainter& painter, const QPointF& tip, const QPointF& along) {
    const QPointF across(-along.y(), along.x());
    QPolygonF arrow;
    arrow << tip << tip - 13.0 * along + 7.0 * across << tip - 13.0 * along - 7.0 * across;
    painter.setPen(QPen(QColor(0, 0, 0, 150), 1.0));
    painter.setBrush(overlayInks().select);
    painter.drawPolygon(arrow);
}

}  // namespace

void paintPanorama(QPainter& painter, const QRectF& area, const PanoramaShape& shape) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(sized(painter.font(), 11));
    const QFontMetricsF metrics(painter.font());
    const double horizon = area.top() + area.height() * shape.rowOf(0.0) / std::max(1, shape.height);
    QPainterPath level;
    level.moveTo(area.left(), horizon);
    level.lineTo(area.right(), horizon);
    strokeRimmed(painter, level, Faint, 1.0, Qt::DotLine);
    for (const AzimuthTick& tick : azimuthTicks(shape)) {
        const double x = area.left() + tick.place * area.width();
        QPainterPath mark;
        mark.moveTo(x, area.bottom());
        mark.lineTo(x, area.bottom() - (tick.major ? 9.0 : 5.0));
        strokeRimmed(painter, mark, Qt::white, tick.major ? 2.0 : 1.0);
        if (tick.text.isEmpty()) continue;
        const double width = metrics.horizontalAdvance(tick.text) + 2.0;
        QRectF box(x - 0.5 * width, area.bottom() - 10.0 - metrics.height(), width, metrics.height());
        if (tick.place == 0.0) box.moveLeft(area.left() + 4.0);
        if (tick.place == 1.0) box.moveRight(area.right() - 4.0);
        if (area.width() < 8.0 * width && tick.place != 0.5) continue;
        paintRimmedText(painter, box, Qt::AlignCenter, tick.text, Qt::white);
    }
    paintArrow(painter, {area.left() + 0.5 * area.width(), area.top() + 14.0}, {0.0, 1.0});
    painter.restore();
}

void paintFront(QPainter& painter, const QRectF& area, const QPointF& ahead) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    const QPointF at(area.left() + ahead.x() * area.width(), area.top() + ahead.y() * area.height());
    const QLineF out(area.center(), at);
    if (out.length() > 20.0) {
        const QPointF along = (at - area.center()) / out.length();
        paintArrow(painter, at, along);
        painter.setFont(sized(painter.font(), 12));
        const QFontMetricsF metrics(painter.font());
        const QString text = OmniTexts::tr("ahead");
        QRectF box(0, 0, metrics.horizontalAdvance(text) + 4.0, metrics.height());
        box.moveCenter(at - 26.0 * along);
        paintRimmedText(painter, box, Qt::AlignCenter, text, Qt::white);
    }
    painter.restore();
}

}  // namespace leitstand
