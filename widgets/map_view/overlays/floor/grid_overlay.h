#pragma once

#include <optional>

#include <QImage>
#include <QRect>
#include <QSize>

#include "widgets/map_view/overlays/floor/kept_picture.h"
#include "widgets/models/map/robots/robot_grid.h"

class QPainter;

namespace leitstand {

struct OverlayStyle;

/// Paints a robot's own grid over the map. Occupied cells have the robot's colour, which is fainter the less
/// probable they are. Free cells have a breath of it. Unknown ones are not painted.
class GridOverlay {
public:
    /// Sets the grid; empty: nothing is painted. Returns whether anything looks different now.
    bool setGrid(std::optional<RobotGrid> grid);
    [[nodiscard]] const std::optional<RobotGrid>& grid() const { return m_grid; }
    void paint(QPainter& painter, const MapProjection& projection, const OverlayStyle& style);

private:
    std::optional<RobotGrid> m_grid;
    QImage m_cells;  ///< a pixel each; null: to be made
    const ThemeColours* m_colours = nullptr;
    KeptPicture m_picture;
};

/// Paints whose grid it is, and what its colours mean, into a box at the left of a widget of @p size. It is
/// above @p below, the box under it (may be null).
void paintGridLegend(QPainter& painter, const RobotGrid& grid, QSize size, const QRect& below,
                     const OverlayStyle& style);

}  // namespace leitstand
