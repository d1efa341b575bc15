#include "widgets/robots/more_robots_button.h"

#include "widgets/painting/pane_paint.h"
#include "widgets/robots/robot_bar_sizes.h"
#include "widgets/robots/robot_signs.h"

namespace leitstand {
namespace {

using robot_bar::Side, robot_bar::Sign, robot_bar::TextSize;
constexpr double ArrowWidth = 5.0;  ///< [px]

}  // namespace

MoreRobotsButton::MoreRobotsButton(End end, QWidget* parent) : QAbstractButton(parent), m_end(end) {
    setFocusPolicy(Qt::TabFocus);
    setCursor(Qt::PointingHandCursor);
    setAccessibleName(end == End::Before ? tr("Robots to the left") : tr("Robots to the right"));
    setToolTip(accessibleName());
    setEnabled(false);
}

QSize MoreRobotsButton::sizeHint() const {
    return {Width, robot_bar::Height};
}

void MoreRobotsButton::show(const HiddenRobots& hidden) {
    if (m_hidden == hidden) return;
    m_hidden = hidden;
    setEnabled(hidden.count > 0);
    const QString what = tr("Robots out of sight: %1").arg(hidden.count);
    setToolTip(hidden.count == 0 ? accessibleName() : what + QLatin1Char('\n') + hidden.details);
    setAccessibleDescription(hidden.count == 0 ? QString() : what + QStringLiteral(". ") + hidden.details);
    update();
}

void MoreRobotsButton::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const ThemeColours& colours = coloursOf(presentTheme());
    const bool alarming = m_hidden.stop.stage != StopStage::None && m_hidden.stop.tone != Tone::Normal;
    painter.setPen(hasFocus() ? colours.select
                   : alarming ? toneColour(m_hidden.stop.tone, colours)
                              : colours.line);
    painter.setBrush(underMouse() && isEnabled() ? colours.hover : colours.window);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
    const double middle = 0.5 * height(), upper = 0.5 * middle + 1.0, lower = 1.5 * middle - 1.0;
    // The arrow points towards the hidden robots.
    const bool before = m_end == End::Before;
    const double tip = before ? Side + 1.0 : width() - Side - 1.0, back = before ? ArrowWidth : -ArrowWidth;
    painter.setPen(
        QPen(isEnabled() ? colours.text : colours.line, 2.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(
        QPolygonF({QPointF(tip + back, upper - 5), QPointF(tip, upper), QPointF(tip + back, upper + 5)}));
    if (m_hidden.count == 0) return;
    painter.setFont(sized(font(), TextSize, true));
    painter.setPen(colours.text);
    painter.drawText(QRectF(before ? 14 : 4, upper - 8, width() - 18, 16),
                     Qt::AlignVCenter | (before ? Qt::AlignRight : Qt::AlignLeft),
                     QString::number(m_hidden.count));
    double x = Side + 1.0;
    if (m_hidden.link != LinkState::Connected) {
        paintLinkSign(painter, QRectF(x, lower - 0.5 * Sign, Sign, Sign), m_hidden.link, colours);
        x += Sign + Side;
    }
    if (m_hidden.stop.stage == StopStage::None) return;
    paintStopSign(painter, QRectF(x, lower - 0.5 * Sign, Sign, Sign), m_hidden.stop,
                  toneColour(m_hidden.stop.tone, colours), colours.window);
    x += Sign + Side - 1.0;
    painter.setPen(colours.text);
    painter.drawText(QRectF(x, lower - 8, width() - x, 16), Qt::AlignLeft | Qt::AlignVCenter,
                     m_hidden.stop.face.letter);
}

}  // namespace leitstand
