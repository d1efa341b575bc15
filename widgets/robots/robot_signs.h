#pragma once

#include <QPainter>
#include <QRectF>

#include "core/robot/link/link_status.h"
#include "widgets/models/live/texts/stop_line.h"
#include "widgets/painting/theme.h"

namespace leitstand {

/// Paints the sign of a link. Circle: connected; square: degraded; cross: lost; ring: never seen.
void paintLinkSign(QPainter& painter, const QRectF& box, LinkState link, const ThemeColours& colours);

/// Paints the sign of a stop in @p ink, on @p paper. Empty square: sent; octagon: not answered for over 1 s;
/// triangle: confirmed, but the robot moves or may move. Filled square: the robot stands; arrow: the robot is
/// being released.
void paintStopSign(QPainter& painter, const QRectF& box, const StopLine& stop, const QColor& ink,
                   const QColor& paper);

}  // namespace leitstand
