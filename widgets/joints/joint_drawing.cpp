#include "widgets/joints/joint_drawing.h"

#include <algorithm>

#include <QPainter>

#include "widgets/painting/pane_paint.h"
#include "widgets/painting/theme.h"

namespace leitstand {
namespace {

constexpr double Margin = 10.0;     // [px]
constexpr int StatusHeight = 20;    // [px]
constexpr double LeastReach = 0.3;  // [m]

}  // namespace

JointDrawing::JointDrawing(QWidget* parent) : QWidget(parent) {
    setAccessibleName(tr("Flippers and arm, from the right"));
}

void JointDrawing::show(const SideView& body, const SideView& reach, const std::vector<JointLine>& lines) {
    m_body = body;
    m_reach = reach;
    m_lines = lines;
    update();
}

void JointDrawing::setStatus(const QString& text, Tone tone) {
    if (text == m_status && tone == m_tone) return;
    m_status = text;
    m_tone = tone;
    setAccessibleDescription(text);
    update();
}

void JointDrawing::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const ThemeColours& colours = coloursOf(presentTheme());
    const QRectF area = QRectF(rect()).adjusted(Margin, Margin, -Margin, -Margin - StatusHeight);
    const Eigen::Vector2d size = (m_reach.high - m_reach.low).cwiseMax(LeastReach);
    const double scale = std::min(area.width() / size.x(), area.height() / size.y());  // [px/m]
    const Eigen::Vector2d middle = 0.5 * (m_reach.low + m_reach.high);
    const auto at = [&](const Eigen::Vector2d& point) {
        return QPointF(area.center().x() + scale * (point.x() - middle.x()),
                       area.center().y() - scale * (point.y() - middle.y()));
    };
    painter.setPen(QPen(colours.line, 1.0));
    const double ground = at({0.0, 0.0}).y();
    painter.drawLine(QPointF(area.left(), ground), QPointF(area.right(), ground));
    painter.setPen(QPen(colours.muted, 1.5));
    painter.setBrush(colours.field);
    painter.drawRoundedRect(
        QRectF(at({m_body.low.x(), m_body.high.y()}), at({m_body.high.x(), m_body.low.y()})), 4.0, 4.0);
    // A mark at the front, so that ahead and behind are not mistaken.
    const QPointF nose = at({m_body.high.x(), 0.5 * (m_body.low.y() + m_body.high.y())});
    painter.setBrush(colours.muted);
    painter.drawPolygon(QPolygonF({nose + QPointF(-3, 0), nose + QPointF(-10, -5), nose + QPointF(-10, 5)}));
    for (const bool chosen : {false, true}) {  // what moves lies on top
        const QColor& colour = chosen ? colours.select : colours.text;
        for (const JointLine& line : m_lines) {
            if (line.chosen != chosen) continue;
            painter.setPen(QPen(colour, 4.0, Qt::SolidLine, Qt::RoundCap));
            painter.drawLine(at(line.from), at(line.to));
            painter.setPen(Qt::NoPen);
            painter.setBrush(colour);
            painter.drawEllipse(at(line.from), 4.0, 4.0);
        }
    }
    if (m_status.isEmpty()) return;
    const QRectF below(Margin, height() - StatusHeight - 2.0, width() - 2.0 * Margin, StatusHeight);
    painter.setFont(fitted(painter.font(), m_status, below.width(), 13, 9, m_tone != Tone::Normal));
    painter.setPen(toneColour(m_tone, colours));
    painter.drawText(
        below, Qt::AlignCenter,
        painter.fontMetrics().elidedText(m_status, Qt::ElideRight, static_cast<int>(below.width())));
}

}  // namespace leitstand
