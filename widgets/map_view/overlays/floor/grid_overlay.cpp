#include "widgets/map_view/overlays/floor/grid_overlay.h"

#include <algorithm>
#include <array>
#include <utility>

#include <QCoreApplication>
#include <QPainter>
#include <QPainterPath>
#include <QTransform>

#include "core/event/map_samples.h"
#include "widgets/map_view/camera/map_camera.h"
#include "widgets/map_view/overlays/floor/legend_squares.h"
#include "widgets/map_view/overlays/overlay_style.h"
#include "widgets/painting/theme.h"

namespace leitstand {
namespace {

constexpr int FreeAlpha = 44, OccupiedAlpha = 225;
constexpr int Tile = 64;  ///< cells along the edge of a part that is painted at once

/// Returns the colour of a cell that is occupied with a probability of @p percent; unknown: none.
QColor colourOf(int percent, const QColor& robot) {
    if (percent < 0 || percent > OccupancyGridSample::Occupied) return Qt::transparent;
    QColor colour = robot;
    colour.setAlpha(FreeAlpha + (OccupiedAlpha - FreeAlpha) * percent / OccupancyGridSample::Occupied);
    return colour;
}

/// Returns a pixel for each cell; the first row is that of the smallest y.
QImage cellsOf(const OccupancyGridSample& grid, const QColor& robot) {
    std::array<QRgb, 256> colours{};
    for (int value = -128; value < 128; ++value)
        colours[static_cast<std::uint8_t>(value)] = qPremultiply(colourOf(value, robot).rgba());
    QImage image(grid.width, grid.height, QImage::Format_ARGB32_Premultiplied);
    auto cell = grid.cells.begin();
    for (int row = 0; row < grid.height; ++row) {
        auto* const line = reinterpret_cast<QRgb*>(image.scanLine(row));
        for (int column = 0; column < grid.width; ++column)
            line[column] = colours[static_cast<std::uint8_t>(*cell++)];
    }
    return image;
}

/// Paints the part @p cells of @p image where it lies; nothing where a corner is behind the eye.
void paintTile(QPainter& painter, const MapProjection& projection, const RobotGrid& grid, const QImage& image,
               const QRect& cells) {
    const QRectF edges(cells);
    const std::array<QPointF, 4> corners = {edges.topLeft(), edges.topRight(), edges.bottomRight(),
                                            edges.bottomLeft()};
    QPolygonF from, to;
    for (const QPointF& corner : corners) {
        const double size = grid.grid->sample.resolution;
        const auto at =
            projection.project(grid.gridInMap * Eigen::Vector3d(size * corner.x(), size * corner.y(), 0.0));
        if (!at) return;
        from << corner;
        to << at->position;
    }
    if (!to.boundingRect().intersects(QRectF(QPointF(0, 0), projection.size()))) return;
    QTransform transform;
    if (!QTransform::quadToQuad(from, to, transform)) return;  // seen from the edge
    painter.setTransform(transform, true);
    painter.drawImage(edges, image, edges);
    painter.resetTransform();
}

}  // namespace

bool GridOverlay::setGrid(std::optional<RobotGrid> grid) {
    if (!grid && !m_grid) return false;
    if (grid && m_grid && sameGrid(*grid, *m_grid)) return false;
    const bool sameCells =
        grid && m_grid && grid->grid == m_grid->grid && grid->robotPlace == m_grid->robotPlace;
    if (!sameCells) m_cells = {};
    m_grid = std::move(grid);
    m_picture.drop();
    return true;
}

void GridOverlay::paint(QPainter& painter, const MapProjection& projection, const OverlayStyle& style) {
    if (!m_grid || m_grid->grid->sample.cells.empty()) return;
    if (m_cells.isNull() || m_colours != style.window) {
        m_colours = style.window;
        m_cells = cellsOf(m_grid->grid->sample, style.window->robot(m_grid->robotPlace));
    }
    m_picture.paint(painter, projection, style, [&](QPainter& making) {
        for (int y = 0; y < m_cells.height(); y += Tile) {
            for (int x = 0; x < m_cells.width(); x += Tile) {
                const QRect tile = QRect(x, y, Tile, Tile).intersected(m_cells.rect());
                paintTile(making, projection, *m_grid, m_cells, tile);
            }
        }
    });
}

void paintGridLegend(QPainter& painter, const RobotGrid& grid, QSize size, const QRect& below,
                     const OverlayStyle& style) {
    const auto square = [&](int percent) {
        return [colour = colourOf(percent, style.window->robot(grid.robotPlace))](
                   QPainter& one, const QPainterPath& path) { one.fillPath(path, colour); };
    };
    paintLegendSquares(painter,
                       {{{}, grid.title},
                        {square(OccupancyGridSample::Occupied),
                         QCoreApplication::translate("leitstand::MapView", "occupied")},
                        {square(0), QCoreApplication::translate("leitstand::MapView", "free")}},
                       size, below, style);
}

}  // namespace leitstand
