#include "widgets/topics/trend_plot.h"

#include <algorithm>
#include <cmath>

#include <QPainter>
#include <QPolygonF>

#include "widgets/painting/pane_paint.h"
#include "widgets/painting/theme.h"

namespace leitstand {
namespace {

constexpr int TextSize = 12;          // [px]
constexpr double Margin = 8.0;        // [px]
constexpr double LeastHeight = 1e-9;  // of the range of numbers

QString worded(double number) {
    return QString::number(number, 'g', 6);
}

}  // namespace

TrendPlot::TrendPlot(QWidget* parent) : QWidget(parent) {
    setAccessibleName(tr("Plot"));
}

void TrendPlot::show(const QString& title, std::vector<std::pair<double, double>> points, double span) {
    std::erase_if(points, [](const auto& point) { return !std::isfinite(point.second); });
    m_title = title;
    m_points = std::move(points);
    m_span = span;
    setAccessibleDescription(
        m_points.empty() ? m_title : m_title + QStringLiteral(": ") + worded(m_points.back().second));
    update();
}

void TrendPlot::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const ThemeColours& colours = coloursOf(presentTheme());
    painter.fillRect(rect(), colours.strip);
    painter.setFont(sized(painter.font(), TextSize));
    const double line = painter.fontMetrics().height();
    const QRectF head(Margin, 4.0, width() - 2.0 * Margin, line);
    painter.setPen(colours.muted);
    const QString newest = m_points.empty() ? QString() : worded(m_points.back().second);
    const double room = head.width() - painter.fontMetrics().horizontalAdvance(newest) - Margin;
    painter.drawText(head, Qt::AlignLeft,
                     painter.fontMetrics().elidedText(m_title, Qt::ElideLeft, static_cast<int>(room)));
    painter.setPen(colours.text);
    painter.drawText(head, Qt::AlignRight, newest);
    if (m_points.empty()) return;
    const auto byNumber = [](const auto& a, const auto& b) { return a.second < b.second; };
    const auto [least, most] = std::minmax_element(m_points.begin(), m_points.end(), byNumber);
    const QRectF area(Margin, head.bottom() + 4.0, width() - 2.0 * Margin, height() - head.bottom() - 10.0);
    const double low = least->second, range = std::max(LeastHeight, most->second - low);
    QPolygonF trend;
    for (const auto& [age, number] : m_points)
        trend << QPointF(area.right() - area.width() * age / m_span,
                         area.bottom() - area.height() * (most->second > low ? (number - low) / range : 0.5));
    painter.setPen(QPen(colours.select, 1.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    if (trend.size() == 1) painter.drawPoint(trend.front());
    painter.drawPolyline(trend);
    if (!(most->second > low)) return;
    painter.setPen(colours.muted);
    painter.drawText(area, Qt::AlignLeft | Qt::AlignTop, worded(most->second));
    painter.drawText(area, Qt::AlignLeft | Qt::AlignBottom, worded(low));
}

}  // namespace leitstand
