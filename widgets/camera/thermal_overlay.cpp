#include "widgets/camera/thermal_overlay.h"

#include <algorithm>
#include <cmath>

#include <QCoreApplication>
#include <QLinearGradient>

#include "widgets/camera/camera_overlay.h"
#include "widgets/models/camera/heat_labels.h"
#include "widgets/models/numbers.h"
#include "widgets/painting/pane_paint.h"

namespace leitstand {
namespace {

struct ThermalTexts {
    Q_DECLARE_TR_FUNCTIONS(leitstand::ThermalOverlay)
};

constexpr double ScaleWidth = 83.0;  // with its numbers [px]

QString celsiusText(double celsius, int decimals) {
    return ThermalTexts::tr("%1 °C").arg(numberText(celsius, decimals));
}

/// Returns @p box moved into @p area.
QRectF within(QRectF box, const QRectF& area) {
    box.moveLeft(std::clamp(box.left(), area.left(), std::max(area.left(), area.right() - box.width())));
    box.moveTop(std::clamp(box.top(), area.top(), std::max(area.top(), area.bottom() - box.height())));
    return box;
}

}  // namespace

void paintThermalScale(QPainter& painter, const QRectF& area, const ThermalRange& range,
                       ThermalPalette palette) {
    painter.save();
    painter.setFont(sized(painter.font(), 11));
    const double line = QFontMetricsF(painter.font()).height();
    const QRectF bar(area.right() - 18.0, area.top() + 0.18 * area.height(), 9.0, 0.64 * area.height());
    QLinearGradient gradient(bar.bottomLeft(), bar.topLeft());
    for (int i = 0; i <= 10; ++i) {
        const float celsius = range.coolest + 0.1F * static_cast<float>(i) * (range.hottest - range.coolest);
        gradient.setColorAt(0.1 * i, QColor(thermalColour(celsius, range, palette)));
    }
    painter.setPen(QPen(QColor(255, 255, 255, 120), 1.0));
    painter.setBrush(gradient);
    painter.drawRect(bar);
    const double width = 60.0, middle = 0.5 * (range.coolest + range.hottest);
    const int decimals = std::abs(middle - std::round(middle)) > 0.05 ? 1 : 0;
    const auto label = [&](double y, const QString& text) {
        paintRimmedText(painter, {bar.left() - width - 5.0, y - 0.5 * line, width, line},
                        Qt::AlignRight | Qt::AlignVCenter, text, Qt::white);
    };
    label(bar.top(), celsiusText(range.hottest, 0));
    if (bar.height() > 5.0 * line) label(bar.center().y(), numberText(middle, decimals));
    label(bar.bottom(), numberText(range.coolest, 0));
    painter.restore();
}

QRectF thermalScaleArea(const QRectF& area) {
    return {area.right() - ScaleWidth, area.top(), ScaleWidth, area.height()};
}

void paintHeat(QPainter& painter, const QRectF& area, const ThermalPicture& picture,
               const std::vector<HeatBlob>& blobs, const QRectF& open, const std::vector<QRectF>& taken) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(sized(painter.font(), 13, true));
    const double across = area.width() / picture.width, down = area.height() / picture.height;
    std::vector<HeatMark> bodies;
    for (const HeatBlob& blob : blobs) {
        const bool body = blob.kind == HeatBlob::Kind::Body;
        const QRectF frame =
            QRectF(area.left() + across * blob.left, area.top() + down * blob.top,
                   across * (blob.right - blob.left + 1), down * (blob.bottom - blob.top + 1))
                .adjusted(-3, -3, 3, 3);
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(QColor(255, 255, 255, body ? 255 : 110), body ? 2.0 : 1.0));
        painter.drawRect(frame);
        if (body) bodies.push_back({frame, blob.mean});
    }
    const QFontMetricsF metrics(painter.font());
    const auto textOf = [](double celsius) {
        return ThermalTexts::tr("%1 person?").arg(celsiusText(celsius, 1));
    };
    const auto sizeOf = [&](double celsius) {
        return QSizeF(metrics.horizontalAdvance(textOf(celsius)) + 4.0, metrics.height());
    };
    const QString brief = ThermalTexts::tr("person?");
    const QSizeF briefSize(metrics.horizontalAdvance(brief) + 4.0, metrics.height());
    for (const HeatLabel& label : heatLabels(bodies, sizeOf, open, taken, briefSize)) {
        const QString text = label.brief ? brief : textOf(label.celsius);
        paintRimmedText(painter, label.box, Qt::AlignCenter, text, Qt::white);
    }
    painter.restore();
}

void paintCelsius(QPainter& painter, const QRectF& area, const QPointF& pointer, float celsius) {
    painter.save();
    painter.setFont(sized(painter.font(), 13, true));
    const QString text = celsiusText(celsius, 1);
    const QFontMetricsF metrics(painter.font());
    const QRectF box(pointer.x() + 12.0, pointer.y() - metrics.height() - 4.0,
                     metrics.horizontalAdvance(text) + 6.0, metrics.height());
    paintRimmedText(painter, within(box, area), Qt::AlignCenter, text, Qt::white);
    painter.restore();
}

}  // namespace leitstand
