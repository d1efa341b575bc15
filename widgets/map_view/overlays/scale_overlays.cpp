#include "widgets/map_view/overlays/scale_overlays.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <QCoreApplication>
#include <QFontMetrics>
#include <QPainter>

#include "widgets/map_view/camera/map_camera.h"
#include "widgets/map_view/overlays/overlay_style.h"

namespace leitstand {
namespace {

constexpr double AxesMargin = 42.0, AxisLength = 20.0;  ///< [px]
constexpr int BarRight = 96, BarBottom = 24, BarEnd = 4, BarLongest = 120;

}  // namespace

double roundLength(double metresPerPixel, double pixels) {
    const double longest = metresPerPixel * pixels;
    const double decade = std::pow(10.0, std::floor(std::log10(longest)));
    for (const double step : {5.0, 2.0}) {
        if (step * decade <= longest) return step * decade;
    }
    return decade;
}

QRect paintScaleBar(QPainter& painter, const MapProjection& projection, double gridStep,
                    const OverlayStyle& style) {
    const double metresPerPixel = projection.metresPerPixel(projection.focusDepth());
    const double length = roundLength(metresPerPixel, BarLongest);
    const int pixels = static_cast<int>(std::lround(length / metresPerPixel));
    const int right = projection.size().width() - BarRight, bottom = projection.size().height() - BarBottom;
    const int decimals = std::max(0, static_cast<int>(std::ceil(-std::log10(length) - 1e-9)));
    const QString text = QStringLiteral("%1 m").arg(numberText(length, decimals, style.locale));

    const QString grid = gridStep <= 0.0 ? QString()
                                         : QCoreApplication::translate("leitstand::MapView", "%1 m grid")
                                               .arg(numberText(gridStep, 0, style.locale));
    painter.setFont(style.font);
    const QFontMetrics metrics = painter.fontMetrics();
    const int height = metrics.height();
    const QRect bar(right - pixels, bottom - BarEnd - height, pixels, height);
    const int gridWidth = grid.isEmpty() ? 0 : metrics.horizontalAdvance(grid) + 14;
    const QRect panel = bar.adjusted(-12 - gridWidth, -4, 12, BarEnd + 9);
    paintPanel(painter, panel, style);
    painter.setPen(asColour(style.colours.text));
    painter.drawText(bar.adjusted(-50, -2, 50, -2), Qt::AlignCenter, text);
    painter.setPen(QPen(asColour(style.colours.text), 1.5));
    painter.drawLine(right - pixels, bottom, right, bottom);
    for (const int end : {right - pixels, right})
        painter.drawLine(end, bottom - BarEnd, end, bottom + BarEnd);
    painter.setPen(asColour(style.colours.muted));
    painter.drawText(bar.adjusted(-14 - gridWidth, height / 2, -pixels - 14, height / 2),
                     Qt::AlignRight | Qt::AlignVCenter, grid);
    return panel;
}

void paintAxes(QPainter& painter, const MapProjection& projection, const OverlayStyle& style) {
    struct Axis {
        Eigen::Vector3d direction;
        QColor colour;
        QString name;
    };
    std::array<Axis, 3> axes = {{{Eigen::Vector3d::UnitX(), QColor(0xE0, 0x5A, 0x4E), QStringLiteral("x")},
                                 {Eigen::Vector3d::UnitY(), QColor(0x3F, 0xA8, 0x5C), QStringLiteral("y")},
                                 {Eigen::Vector3d::UnitZ(), QColor(0x4F, 0x8F, 0xE8), QStringLiteral("z")}}};
    const MapCamera& camera = projection.camera();
    // Axes that point away from the viewer are painted first.
    std::sort(axes.begin(), axes.end(), [&camera](const Axis& a, const Axis& b) {
        return a.direction.dot(camera.forward()) > b.direction.dot(camera.forward());
    });
    const QPointF origin(projection.size().width() - AxesMargin, projection.size().height() - AxesMargin);
    painter.setPen(Qt::NoPen);
    painter.setBrush(asColour(style.colours.panel));
    painter.drawEllipse(origin, AxisLength + 12.0, AxisLength + 12.0);
    painter.setFont(style.font);
    for (const Axis& axis : axes) {
        const QPointF along(axis.direction.dot(camera.right()), -axis.direction.dot(camera.up()));
        const double seen = std::hypot(along.x(), along.y());
        if (seen < 0.05) continue;  // points at the viewer
        painter.setPen(QPen(axis.colour, 2.0, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(origin, origin + AxisLength * along);
        const QPointF middle = origin + AxisLength * along + 8.0 * along / seen;
        painter.drawText(QRectF(middle - QPointF(10, 10), QSizeF(20, 20)), Qt::AlignCenter, axis.name);
    }
}

}  // namespace leitstand
