#include "widgets/map_view/overlays/floor/floor_overlay.h"

#include <array>
#include <utility>
#include <vector>

#include <QCoreApplication>
#include <QPainter>
#include <QPainterPath>

#include "widgets/map_view/camera/map_camera.h"
#include "widgets/map_view/overlays/floor/legend_squares.h"
#include "widgets/map_view/overlays/overlay_style.h"
#include "widgets/painting/theme.h"

namespace leitstand {
namespace {

constexpr int SeenAlpha = 84, MissedAlpha = 46, HatchAlpha = 215;

QColor clear(QColor colour, int alpha) {
    colour.setAlpha(alpha);
    return colour;
}

/// Fills @p area as seen floor (a tint) or missed floor (a hatch on a faint tint).
template <class Area>
void fill(QPainter& painter, const Area& area, bool seen, const ThemeColours& colours) {
    if (seen) return painter.fillPath(area, clear(colours.fine, SeenAlpha));
    painter.fillPath(area, clear(colours.attention, MissedAlpha));
    painter.fillPath(area, QBrush(clear(colours.attention, HatchAlpha), Qt::BDiagPattern));
}

QString legendText(SearchSensor sensor, bool seen) {
    switch (sensor) {
        case SearchSensor::Camera:
            return seen ? QCoreApplication::translate("leitstand::MapView", "seen by camera")
                        : QCoreApplication::translate("leitstand::MapView", "missed by camera");
        case SearchSensor::Infrared:
            return seen ? QCoreApplication::translate("leitstand::MapView", "seen by infrared")
                        : QCoreApplication::translate("leitstand::MapView", "missed by infrared");
        case SearchSensor::Scanner:
            break;
    }
    return seen ? QCoreApplication::translate("leitstand::MapView", "seen by scanner")
                : QCoreApplication::translate("leitstand::MapView", "missed by scanner");
}

/// Paints the patches of @p tint that are on screen.
void paintPatches(QPainter& painter, const MapProjection& projection, const FloorTint& tint,
                  const ThemeColours& colours) {
    std::array<QPainterPath, 2> areas;  // missed, seen
    for (QPainterPath& area : areas) area.setFillRule(Qt::WindingFill);
    const QRectF screen(QPointF(-100, -100), projection.size() + QSize(200, 200));
    for (const FloorPatch& patch : tint.patches) {
        const auto corner = [&](float x, float y) {
            return Eigen::Vector3f(x, y, patch.height).cast<double>().eval();
        };
        const QPolygonF corners = projection.outline(std::array<Eigen::Vector3d, 4>{
            corner(patch.low.x(), patch.low.y()), corner(patch.high.x(), patch.low.y()),
            corner(patch.high.x(), patch.high.y()), corner(patch.low.x(), patch.high.y())});
        if (corners.size() < 3 || !corners.boundingRect().intersects(screen)) continue;
        QPainterPath& area = areas[patch.seen ? 1 : 0];
        area.addPolygon(corners);
        area.closeSubpath();
    }
    fill(painter, areas[0], false, colours);
    fill(painter, areas[1], true, colours);
}

}  // namespace

void FloorOverlay::setTint(FloorTintPtr tint) {
    m_tint = std::move(tint);
    m_picture.drop();
}

void FloorOverlay::paint(QPainter& painter, const MapProjection& projection, const OverlayStyle& style) {
    if (!m_tint) return;
    m_picture.paint(painter, projection, style, [&](QPainter& making) {  // patches meet without seams
        paintPatches(making, projection, *m_tint, *style.window);
    });
}

QRect paintFloorLegend(QPainter& painter, const FloorTint& tint, QSize size, const QRect& below,
                       const OverlayStyle& style) {
    std::vector<LegendSquare> squares;
    for (const bool seen : {true, false}) {
        squares.push_back({[&style, seen](QPainter& one, const QPainterPath& square) {
                               fill(one, square, seen, *style.window);
                           },
                           legendText(tint.sensor, seen)});
    }
    return paintLegendSquares(painter, squares, size, below, style);
}

}  // namespace leitstand
