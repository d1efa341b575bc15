#include "app/report/gas_curve.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainter>
#include <QPolygonF>

#include "app/report/report_numbers.h"
#include "app/report/report_times.h"
#include "core/base/time.h"

namespace leitstand {
namespace {

constexpr int Parts = 4;  ///< of the time axis

struct CurveText {
    Q_DECLARE_TR_FUNCTIONS(CurveText)
};

/// Returns 1, 2 or 5 times a power of ten, so that @p span holds three to seven of them.
double stepFor(double span) {
    const double power = std::pow(10.0, std::floor(std::log10(span / 3.0)));
    for (const double times : {5.0, 2.0}) {
        if (span / (times * power) >= 3.0) return times * power;
    }
    return power;
}

/// Ranges of the axes and their frame on the page.
struct Axes {
    QRectF frame;
    double least = 0.0, most = 1.0, step = 1.0;  ///< of CO2 [ppm]
    Time begin{}, end{};

    [[nodiscard]] double height(double ppm) const {
        return frame.bottom() - frame.height() * (ppm - least) / (most - least);
    }
    [[nodiscard]] double place(Time at) const {
        return frame.left() + frame.width() * toSeconds(at - begin) / toSeconds(end - begin);
    }
};

Axes axesOf(const GasTrace& trace, const QRectF& frame) {
    Axes axes;
    axes.frame = frame;
    const auto [low, high] = std::minmax_element(trace.readings.begin(), trace.readings.end(),
                                                 [](const auto& a, const auto& b) { return a.ppm < b.ppm; });
    axes.step = stepFor(std::max(100.0, high->ppm - low->ppm));
    axes.least = axes.step * std::floor(low->ppm / axes.step);
    axes.most = axes.step * (std::floor(high->ppm / axes.step) + 1.0);
    axes.begin = trace.readings.front().at;
    axes.end = trace.readings.back().at;
    return axes;
}

}  // namespace

bool isCurve(const GasTrace& trace) {
    return trace.readings.size() >= 2 && trace.readings.front().at < trace.readings.back().at;
}

void drawGasCurve(QPainter& painter, const QRectF& room, const GasTrace& trace) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    const double line = QFontMetricsF(painter.font()).height();
    const double left = 0.1 * room.width();
    // Above the frame are the title, the name of the axis and half of the topmost number.
    const Axes axes = axesOf(trace, room.adjusted(left, 2.6 * line, -0.1 * room.width(), -2.2 * line));
    const QPen thin(QColor(0x99, 0x99, 0x99), 0.5), ink(Qt::black, 1.0);
    painter.setPen(ink);
    painter.drawText(QRectF(room.left(), room.top(), room.width(), line), Qt::AlignHCenter,
                     CurveText::tr("CO₂ measured by %1").arg(QString::fromStdString(trace.robot)));
    painter.drawText(QRectF(room.left(), room.top() + line, 2.0 * left, line), Qt::AlignLeft,
                     CurveText::tr("CO₂ [ppm]"));
    painter.drawText(QRectF(room.left(), room.bottom() - line, room.width(), line), Qt::AlignHCenter,
                     CurveText::tr("time of day"));
    for (double ppm = axes.least; ppm < axes.most + 0.5 * axes.step; ppm += axes.step) {
        const double y = axes.height(ppm);
        painter.setPen(thin);
        painter.drawLine(QPointF(axes.frame.left(), y), QPointF(axes.frame.right(), y));
        painter.setPen(ink);
        painter.drawText(QRectF(room.left(), y - line / 2, left - 6.0, line),
                         Qt::AlignRight | Qt::AlignVCenter, reportNumber(ppm, 0));
    }
    for (int i = 0; i <= Parts; ++i) {
        const Time at = axes.begin + i * ((axes.end - axes.begin) / Parts);
        const double x = axes.place(at);
        painter.setPen(thin);
        painter.drawLine(QPointF(x, axes.frame.top()), QPointF(x, axes.frame.bottom() + 4.0));
        painter.setPen(ink);
        painter.drawText(QRectF(x - left, axes.frame.bottom() + 4.0, 2.0 * left, line), Qt::AlignHCenter,
                         reportClock(at));
    }
    QPolygonF curve;
    for (const GasTrace::Reading& reading : trace.readings)
        curve << QPointF(axes.place(reading.at), axes.height(reading.ppm));
    painter.setPen(QPen(QColor(0x00, 0x72, 0xB2), 2.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(curve);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(0xD5, 0x5E, 0x00));
    painter.drawEllipse(curve.back(), 3.0, 3.0);
    painter.restore();
}

}  // namespace leitstand
