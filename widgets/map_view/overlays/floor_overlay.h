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

/// Tints searched floor and hatches missed floor. Keeps its picture until the camera moves: robots, trails
/// and tools over it are painted far more often.
class FloorOverlay {
public:
    void setTint(FloorTintPtr tint);  ///< null: nothing
    [[nodiscard]] const FloorTintPtr& tint() const { return m_tint; }
    void paint(QPainter& painter, const MapProjection& projection, const OverlayStyle& style);
    /// How many times the picture was made; for tests.
    [[nodiscard]] int made() const { return m_made; }

private:
    void make(const MapProjection& projection, double ratio, const OverlayStyle& style);

    FloorTintPtr m_tint;
    QImage m_picture;  ///< last one made; null: to be made
    MapCamera m_camera;
    const ThemeColours* m_colours = nullptr;  ///< of the theme of m_picture
    int m_made = 0;
};

/// Paints the meaning of tint and hatch into a box at the left of a widget of @p size, above @p below (the
/// legend's box; may be null).
void paintFloorLegend(QPainter& painter, const FloorTint& tint, QSize size, const QRect& below,
                      const OverlayStyle& style);

}  // namespace leitstand
