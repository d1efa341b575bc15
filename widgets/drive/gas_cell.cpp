#include "widgets/drive/gas_cell.h"

#include <algorithm>
#include <chrono>

#include <QPolygonF>

#include "widgets/drive/gauge.h"

namespace leitstand {
namespace {

/// Interval of repaints while only the trend's ages change; the trend spans two minutes.
constexpr std::chrono::milliseconds TrendEvery(250);

bool sameWords(const GasFigures& a, const GasFigures& b) {
    return a.alarm == b.alarm && a.fitted == b.fitted && a.value == b.value && a.arrow == b.arrow &&
           a.caption == b.caption && a.samples.empty() == b.samples.empty();
}

}  // namespace

GasCell::GasCell(QWidget* parent) : QWidget(parent) {
    setAccessibleName(tr("CO₂"));
    m_trendDue.setSingleShot(true);
    m_trendDue.setInterval(TrendEvery);
    connect(&m_trendDue, &QTimer::timeout, this, qOverload<>(&QWidget::update));
}

void GasCell::show(const GasFigures& gas) {
    const bool news = !sameWords(gas, m_gas);
    m_gas = gas;
    if (!news) {
        if (!m_trendDue.isActive()) m_trendDue.start();
        return;
    }
    const QString text = tr("CO₂ %1 %2 %3\n%4").arg(gas.value.value, gas.value.unit, gas.arrow, gas.caption);
    setAccessibleDescription(text);
    setToolTip(text);
    update();
}

void GasCell::paintTrend(QPainter& painter, const QRectF& area) const {
    const ThemeColours& colours = coloursOf(presentTheme());
    double least = 400.0, most = 1.1 * m_gas.alarm;  // of clean air [ppm]; the alarm level stays in sight
    for (const auto& [age, ppm] : m_gas.samples) {
        least = std::min(least, ppm);
        most = std::max(most, ppm);
    }
    const auto heightOf = [&](double ppm) {
        return area.bottom() - area.height() * (ppm - least) / (most - least);
    };
    painter.setPen(QPen(colours.act, 1.0, Qt::DotLine));
    painter.drawLine(QPointF(area.left(), heightOf(m_gas.alarm)),
                     QPointF(area.right(), heightOf(m_gas.alarm)));
    QPolygonF line;
    for (const auto& [age, ppm] : m_gas.samples)
        line << QPointF(area.right() - area.width() * age / ValueTrend::Span, heightOf(ppm));
    painter.setPen(QPen(colours.text, 2.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(line);
}

void GasCell::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const ThemeColours& colours = coloursOf(presentTheme());
    painter.fillRect(rect(), colours.strip);
    const double left = 12.0, inner = width() - 22.0;
    paintCaption(painter, {left, 8, inner, 18}, tr("CO₂"), colours.muted);
    double end = paintFigure(painter, {left, 28, inner - 18.0, 32}, m_gas.value, NumberSize, colours);
    if (!m_gas.arrow.isEmpty()) {
        painter.setFont(sized(painter.font(), 17, true));
        painter.setPen(toneColour(m_gas.value.tone, colours));
        painter.drawText(QRectF(end + 3.0, 28, 18, 32), Qt::AlignLeft | Qt::AlignVCenter, m_gas.arrow);
    }
    painter.setFont(sized(painter.font(), CaptionSize));
    const double captions = 2.0 * QFontMetricsF(painter.font()).height() + 8.0;
    const QRectF area(left, 66, inner, std::min(64.0, height() - 66.0 - captions - 4.0));
    if (m_gas.fitted && area.height() > 24.0) paintTrend(painter, area);
    painter.setFont(sized(painter.font(), CaptionSize));
    painter.setPen(colours.muted);
    const double y = m_gas.fitted ? std::max(area.bottom() + 8.0, 66.0) : 66.0;
    paintWrapped(painter, {left, y, inner, height() - y}, m_gas.caption, 2);
}

}  // namespace leitstand
