#include "widgets/robots/robot_signs.h"

#include "widgets/alarms/alarm_delegate.h"

namespace leitstand {

void paintLinkSign(QPainter& painter, const QRectF& box, LinkState link, const ThemeColours& colours) {
    painter.setPen(Qt::NoPen);
    switch (link) {
        case LinkState::Connected:
            painter.setBrush(colours.fine);
            painter.drawEllipse(box);
            break;
        case LinkState::Degraded:
            painter.setBrush(colours.attention);
            painter.drawRect(box.adjusted(0.5, 0.5, -0.5, -0.5));
            break;
        case LinkState::Lost:
            painter.setPen(QPen(colours.act, 2.5, Qt::SolidLine, Qt::RoundCap));
            painter.drawLine(box.topLeft(), box.bottomRight());
            painter.drawLine(box.topRight(), box.bottomLeft());
            break;
        case LinkState::NeverSeen:
            painter.setPen(QPen(colours.muted, 1.5));
            painter.setBrush(Qt::NoBrush);
            painter.drawEllipse(box.adjusted(1, 1, -1, -1));
            break;
    }
}

void paintStopSign(QPainter& painter, const QRectF& box, const StopLine& stop, const QColor& ink,
                   const QColor& paper) {
    const QRectF square = box.adjusted(1, 1, -1, -1);
    painter.setPen(QPen(ink, 1.5));
    switch (stop.stage) {
        case StopStage::None:
            break;
        case StopStage::Sent:
            if (stop.tone == Tone::Act) {
                paintAlarmSign(painter, box, AlarmSeverity::Act, true, ink, paper);
                break;
            }
            painter.setBrush(Qt::NoBrush);
            painter.drawRect(square);
            break;
        case StopStage::Acknowledged:
            paintAlarmSign(painter, box, AlarmSeverity::Attention, true, ink, paper);
            break;
        case StopStage::Standing:
            painter.fillRect(square, ink);
            break;
        case StopStage::Releasing:
            painter.setBrush(ink);
            painter.drawPolygon(
                QPolygonF({box.topLeft() + QPointF(1.5, 1.0), QPointF(box.right() - 1.0, box.center().y()),
                           box.bottomLeft() + QPointF(1.5, -1.0)}));
            break;
    }
}

}  // namespace leitstand
