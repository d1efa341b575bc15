#include "widgets/drive/attitude_gauge.h"

#include <algorithm>
#include <cmath>

#include <QPainterPath>

#include "core/base/pose.h"
#include "widgets/drive/gauge.h"

namespace leitstand {
namespace {

/// Returns the horizon's distance from the middle of a dial of radius 1 at the pitch limit. Its ends then
/// reach the dots, as at the roll limit.
double offsetAtLimit(const AttitudeFigures& attitude) {
    const bool dotted = attitude.maxRoll > 0.0 && attitude.maxRoll < degrees(85);
    return dotted ? std::sin(attitude.maxRoll) : 0.66;
}

}  // namespace

AttitudeGauge::AttitudeGauge(QWidget* parent) : QWidget(parent) {
    setAccessibleName(tr("Attitude"));
    setToolTip(tr("The blue line is the horizon. Where it reaches the dots, the robot tips over."));
}

void AttitudeGauge::show(const AttitudeFigures& attitude) {
    m_attitude = attitude;
    setAccessibleDescription(attitude.text + QLatin1Char(' ') + attitude.limits);
    update();
}

void AttitudeGauge::paintDial(QPainter& painter, const QPointF& centre, double radius) const {
    const ThemeColours& colours = coloursOf(presentTheme());
    const QRectF circle(centre.x() - radius, centre.y() - radius, 2.0 * radius, 2.0 * radius);
    painter.setPen(QPen(colours.line, 1.5));
    painter.setBrush(colours.window);
    painter.drawEllipse(circle);
    // Dots beyond the roll limit, on all four sides.
    const double limit = inDegrees(m_attitude.maxRoll);
    if (limit > 0.0 && limit < 85.0) {
        QPen dots(colours.act, 3.0, Qt::CustomDashLine, Qt::RoundCap);
        dots.setDashPattern({0.1, 1.8});
        painter.setPen(dots);
        painter.setBrush(Qt::NoBrush);
        const double span = std::min(30.0, 90.0 - limit);
        for (const double from : {limit, 180.0 - limit - span, 180.0 + limit, 360.0 - limit - span})
            painter.drawArc(circle, static_cast<int>(16.0 * from), static_cast<int>(16.0 * span));
    }
    if (m_attitude.known) {
        // Right side down: the horizon's right end rises. Nose down: it is higher.
        const double reach = m_attitude.maxPitch > 0.0 ? m_attitude.maxPitch : degrees(30.0);
        const double offset =
            -radius * std::clamp(offsetAtLimit(m_attitude) * m_attitude.pitch / reach, -0.92, 0.92);
        const QPointF along(std::cos(m_attitude.roll), -std::sin(m_attitude.roll));
        const QPointF middle =
            centre + offset * QPointF(std::sin(m_attitude.roll), std::cos(m_attitude.roll));
        const double half = std::sqrt(std::max(0.0, radius * radius - offset * offset));
        const bool calm = m_attitude.tone == Tone::Normal;
        painter.setPen(QPen(calm ? colours.select : toneColour(m_attitude.tone, colours), calm ? 2.5 : 4.0));
        painter.drawLine(middle - half * along, middle + half * along);
    }
    // The robot itself.
    painter.setPen(QPen(m_attitude.known ? colours.text : colours.muted, 2.5));
    const double wing = 0.26 * radius;
    painter.drawLine(centre - QPointF(wing, 0), centre + QPointF(wing, 0));
    painter.drawLine(centre, centre + QPointF(0, 0.5 * wing));
}

void AttitudeGauge::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    const ThemeColours& colours = coloursOf(presentTheme());
    painter.fillRect(rect(), colours.strip);
    painter.setRenderHint(QPainter::Antialiasing);
    const double inner = width() - 20.0;
    paintCaption(painter, {12, 8, inner, 18}, tr("Attitude"), colours.muted);
    const bool limits = !m_attitude.limits.isEmpty() && height() >= 170;
    const double below = limits ? 42.0 : 24.0;
    const double radius = std::max(20.0, std::min(0.5 * inner, 0.5 * (height() - 30.0 - below - 6.0)));
    paintDial(painter, {0.5 * width(), 30.0 + radius}, radius);
    const double line = height() - below;
    painter.setFont(fitted(painter.font(), m_attitude.text, inner + 8.0, CaptionSize, 9,
                           m_attitude.tone == Tone::Attention || m_attitude.tone == Tone::Act));
    painter.setPen(toneColour(m_attitude.tone, colours));
    painter.drawText(QRectF(4, line, width() - 8.0, 18), Qt::AlignCenter, m_attitude.text);
    if (!limits) return;
    painter.setFont(fitted(painter.font(), m_attitude.limits, inner + 8.0, 11, 9, false));
    painter.setPen(colours.muted);
    painter.drawText(QRectF(4, line + 17.0, width() - 8.0, 18), Qt::AlignCenter, m_attitude.limits);
}

}  // namespace leitstand
