#pragma once

#include <QRect>
#include <QSize>

#include "core/mission/coverage/floor_tint.h"
#include "widgets/map_view/overlays/floor/kept_picture.h"

class QPainter;

namespace leitstand {

struct OverlayStyle;

/// Tints searched floor and hatches missed floor.
class FloorOverlay {
public:
    void setTint(FloorTintPtr tint);  ///< null: nothing is painted
    [[nodiscard]] const FloorTintPtr& tint() const { return m_tint; }
    void paint(QPainter& painter, const MapProjection& projection, const OverlayStyle& style);
    /// Number of times that the picture was made; for tests.
    [[nodiscard]] int made() const { return m_picture.made(); }

private:
    FloorTintPtr m_tint;
    KeptPicture m_picture;
};

/// Paints what tint and hatching mean into a box at the left of a widget of @p size. It is above @p below,
/// the box of the legend (may be null). Returns the box.
QRect paintFloorLegend(QPainter& painter, const FloorTint& tint, QSize size, const QRect& below,
                       const OverlayStyle& style);

}  // namespace leitstand
