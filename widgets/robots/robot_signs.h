#pragma once

#include <QPainter>
#include <QRectF>

#include "core/robot/link/link_status.h"
#include "widgets/models/live/texts/stop_line.h"
#include "widgets/painting/theme.h"

namespace leitstand {

/// The sign of a link. Circle: connected; square: degraded; cross: lost; ring: not heard yet.
void paintLinkSign(QPainter& painter, const QRectF& box, LinkState link, const ThemeColours& colours);

/// The sign of a stop in @p ink, on @p paper. Empty square: sent; octagon: nobody answers; triangle: the
/// robot moves, or may; square: it stands; arrow: it is released.
void paintStopSign(QPainter& painter, const QRectF& box, const StopLine& stop, const QColor& ink,
                   const QColor& paper);

}  // namespace leitstand
