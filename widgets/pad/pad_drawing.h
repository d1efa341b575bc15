#pragma once

#include <QPainter>
#include <QRectF>

#include "core/station/pad/pad_state.h"
#include "widgets/models/pad/pad_callouts.h"
#include "widgets/painting/theme.h"

namespace leitstand {

/// Width by height of the drawing of a pad.
inline constexpr double PadAspect = 1.6;

/// Where @p spot is in the drawing of a known pad that fills @p box.
[[nodiscard]] QPointF padSpotAt(const PadSpot& spot, const QRectF& box);
/// Draws the outline of a known pad into @p box.
void drawPadBody(QPainter& painter, const QRectF& box, const ThemeColours& colours);
/// Draws its controls: what is bound in text colour, STOP red, what is held blue and filled, sticks where
/// they are pushed.
void drawPadControls(QPainter& painter, const QRectF& box, const PadCallouts& callouts, const PadState& state,
                     const ThemeColours& colours);

}  // namespace leitstand
