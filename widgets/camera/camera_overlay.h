#pragma once

#include <QPainter>
#include <QPainterPath>
#include <QRectF>

#include "widgets/camera/camera_pane.h"

namespace leitstand {

/// Draws @p overlay over the picture, which fills @p picture. The header of the pane ends at @p top [px].
void paintCameraOverlay(QPainter& painter, const QRectF& picture, double top, const CameraOverlay& overlay);

/// Returns the dark theme's colours. Overlays use them in every theme, since pictures do not depend on the
/// theme.
[[nodiscard]] const ThemeColours& overlayInks();
/// Draws @p shape in @p colour with a dark rim.
void strokeRimmed(QPainter& painter, const QPainterPath& shape, const QColor& colour, double width,
                  Qt::PenStyle style = Qt::SolidLine);
/// Paints @p text into @p box with a dark rim, so that it is legible on any picture. @p flags:
/// Qt::AlignmentFlag.
void paintRimmedText(QPainter& painter, const QRectF& box, int flags, const QString& text,
                     const QColor& colour);

}  // namespace leitstand
