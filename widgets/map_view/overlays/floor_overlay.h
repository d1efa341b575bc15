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

/// The floor that was searched in a tint, what was missed of it hatched. The picture of it is kept until the
/// camera moves: robots, trails and tools over it are painted far more often.
class FloorOverlay {
public:
    void setTint(FloorTintPtr tint);  ///< null: nothing
    [[nodiscard]] const FloorTintPtr& tint() const { return m_tint; }
    void paint(QPainter& painter, const MapProjection& projection, const OverlayStyle& style);
    /// How often the picture was made; for tests.
    [[nodiscard]] int made() const { return m_made; }

private:
    void make(const MapProjection& projection, double ratio, const OverlayStyle& style);

    FloorTintPtr m_tint;
    QImage m_picture;  ///< as made last; null: to be made
    MapCamera m_camera;
    const ThemeColours* m_colours = nullptr;  ///< of a theme, likewise
    int m_made = 0;
};

/// What tint and hatch mean, in a box above @p below (the legend's; may be null) at the left of a widget of
/// @p size.
void paintFloorLegend(QPainter& painter, const FloorTint& tint, QSize size, const QRect& below,
                      const OverlayStyle& style);

}  // namespace leitstand
