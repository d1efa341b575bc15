#include "widgets/map_view/robots/drawing_overlay.h"

#include <algorithm>

#include <QFontMetricsF>
#include <QPainter>
#include <QVector>

#include "widgets/map_view/camera/map_camera.h"
#include "widgets/map_view/overlays/overlay_style.h"
#include "widgets/models/map/robots/robot_mark.h"
#include "widgets/painting/pane_paint.h"

namespace leitstand {
namespace {

constexpr double LineWidth = 1.6, RimWidth = 3.4, DotSize = 4.0;  // [px]
constexpr double LeastOpacity = 0.35;         // what is nearly transparent would be lost on the map
constexpr int TextSize = 12, TextMargin = 4;  // [px]

QColor colourOf(const MarkerColour& from) {
    return QColor::fromRgbF(from.r, from.g, from.b, std::max(from.a, static_cast<float>(LeastOpacity)));
}

/// Appends what is seen of @p line.
void addLines(QVector<QLineF>& lines, const Drawings::Line& line, const MapProjection& projection) {
    std::optional<QPointF> last;
    for (const Eigen::Vector3d& place : line.places) {
        const auto seen = projection.project(place);
        if (seen && last) lines << QLineF(*last, seen->position);
        last = seen ? std::optional(seen->position) : std::nullopt;
    }
}

void paintText(QPainter& painter, const MapProjection& projection, const Drawings::Text& text,
               const OverlayStyle& style) {
    const auto at = projection.project(text.place);
    if (!at || !QRectF(QPointF(), QSizeF(projection.size())).contains(at->position)) return;
    painter.setFont(sized(style.font, TextSize));
    const QFontMetricsF metrics(painter.font());
    QRectF box(QPointF(), QSizeF(metrics.horizontalAdvance(text.text) + 2 * TextMargin, metrics.height()));
    box.moveCenter(at->position);
    paintPanel(painter, box, style);
    painter.setPen(asColour(style.colours.text));
    painter.drawText(box, Qt::AlignCenter, text.text);
}

}  // namespace

void paintDrawings(QPainter& painter, const MapProjection& projection, const std::vector<RobotMark>& robots,
                   const OverlayStyle& style) {
    const QColor rim = asColour(style.colours.background);
    painter.setBrush(Qt::NoBrush);
    for (const RobotMark& robot : robots) {
        if (!robot.drawings) continue;
        for (const Drawings::Line& line : robot.drawings->lines) {
            QVector<QLineF> seen;
            addLines(seen, line, projection);
            painter.setPen(QPen(rim, RimWidth));
            painter.drawLines(seen);
            painter.setPen(QPen(colourOf(line.colour), LineWidth));
            painter.drawLines(seen);
        }
        for (const Drawings::Line& dots : robot.drawings->dots) {
            QVector<QPointF> seen;
            for (const Eigen::Vector3d& place : dots.places)
                if (const auto at = projection.project(place)) seen << at->position;
            painter.setPen(QPen(colourOf(dots.colour), DotSize, Qt::SolidLine, Qt::RoundCap));
            painter.drawPoints(seen.data(), static_cast<int>(seen.size()));
        }
        for (const Drawings::Text& text : robot.drawings->texts) paintText(painter, projection, text, style);
    }
}

}  // namespace leitstand
