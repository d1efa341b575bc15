#pragma once

#include <QPainter>
#include <QRectF>

#include "core/station/pad/pad_state.h"
#include "widgets/models/pad/pad_callouts.h"
#include "widgets/painting/theme.h"

namespace leitstand {

/// Width divided by height of the drawing of a pad.
inline constexpr double PadAspect = 1.6;

/// Returns the position of @p spot in the drawing of a known pad that fills @p box.
[[nodiscard]] QPointF padSpotAt(const PadSpot& spot, const QRectF& box);
/// Draws the outline of a known pad into @p box.
void drawPadBody(QPainter& painter, const QRectF& box, const ThemeColours& colours);
/// Draws the pad's controls: bound ones in the text colour, STOP red, held ones filled blue, sticks at their
/// present positions.
void drawPadControls(QPainter& painter, const QRectF& box, const PadCallouts& callouts, const PadState& state,
                     const ThemeColours& colours);

}  // namespace leitstand
