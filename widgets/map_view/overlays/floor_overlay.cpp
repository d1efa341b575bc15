#include "widgets/map_view/overlays/floor_overlay.h"

#include <algorithm>
#include <array>
#include <utility>

#include <QCoreApplication>
#include <QFontMetrics>
#include <QPainter>
#include <QPainterPath>

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
    m_picture = {};
}

void FloorOverlay::make(const MapProjection& projection, double ratio, const OverlayStyle& style) {
    m_picture = QImage(projection.size() * ratio, QImage::Format_ARGB32_Premultiplied);
    m_picture.setDevicePixelRatio(ratio);
    m_picture.fill(Qt::transparent);
    m_camera = projection.camera();
    m_colours = style.window;
    ++m_made;
    QPainter painter(&m_picture);  // without antialiasing: patches meet without seams
    paintPatches(painter, projection, *m_tint, *m_colours);
}

void FloorOverlay::paint(QPainter& painter, const MapProjection& projection, const OverlayStyle& style) {
    if (!m_tint || projection.size().isEmpty()) return;
    const double ratio = painter.device()->devicePixelRatioF();
    const bool same = m_picture.size() == projection.size() * ratio &&
                      qFuzzyCompare(m_picture.devicePixelRatio(), ratio) && m_camera == projection.camera() &&
                      m_colours == style.window;
    if (!same) make(projection, ratio, style);
    painter.drawImage(QPoint(0, 0), m_picture);
}

void paintFloorLegend(QPainter& painter, const FloorTint& tint, QSize size, const QRect& below,
                      const OverlayStyle& style) {
    constexpr int Margin = 12, Padding = 9, Square = 14, Gap = 6, Space = 14;
    painter.setFont(style.font);
    const QFontMetrics metrics = painter.fontMetrics();
    const QString seen = legendText(tint.sensor, true), missed = legendText(tint.sensor, false);
    const int height = metrics.height() + 10;
    const int bottom = below.isNull() ? size.height() - Margin : below.top() - Gap;
    const int width = 2 * (Padding + Square + Gap) + Space + metrics.horizontalAdvance(seen) +
                      metrics.horizontalAdvance(missed) + 4;
    const QRect box(Margin, bottom - height, width, height);
    paintPanel(painter, box, style);
    int x = box.left() + Padding;
    for (const bool one : {true, false}) {
        const QRect square(x, box.center().y() - Square / 2 + 1, Square, Square);
        QPainterPath path;
        path.addRect(square);
        fill(painter, path, one, *style.window);
        painter.setBrush(Qt::NoBrush);
        painter.setPen(asColour(style.colours.muted));
        painter.drawRect(square);
        x += Square + Gap;
        painter.setPen(asColour(style.colours.text));
        const QString& text = one ? seen : missed;
        painter.drawText(QRect(x, box.top(), metrics.horizontalAdvance(text) + 2, box.height()),
                         Qt::AlignVCenter, text);
        x += metrics.horizontalAdvance(text) + Space;
    }
}

}  // namespace leitstand
