#pragma once

#include <QImage>
#include <QRect>
#include <QSize>

#include "core/mission/coverage/floor_tint.h"
#include "widgets/map_view/camera/map_camera.h"

class QPainter;

namespace leitstand {

struct OverlayStyle;
struct ThemeColours;

/// Tints searched floor and hatches missed floor. Keeps its picture until the camera moves, since robots,
/// trails and tools over it are painted far more often.
class FloorOverlay {
public:
    void setTint(FloorTintPtr tint);  ///< null: nothing is painted
    [[nodiscard]] const FloorTintPtr& tint() const { return m_tint; }
    void paint(QPainter& painter, const MapProjection& projection, const OverlayStyle& style);
    /// Number of times that the picture was made; for tests.
    [[nodiscard]] int made() const { return m_made; }

private:
    void make(const MapProjection& projection, double ratio, const OverlayStyle& style);

    FloorTintPtr m_tint;
    QImage m_picture;  ///< picture that was made last; null: it must be made
    MapCamera m_camera;
    const ThemeColours* m_colours = nullptr;  ///< colours of m_picture's theme
    int m_made = 0;
};

/// Paints what tint and hatching mean into a box at the left of a widget of @p size. It is above @p below,
/// the box of the legend (may be null).
void paintFloorLegend(QPainter& painter, const FloorTint& tint, QSize size, const QRect& below,
                      const OverlayStyle& style);

}  // namespace leitstand
