#pragma once

#include <QPainter>
#include <QPainterPath>
#include <QRectF>

#include "widgets/camera/camera_pane.h"

namespace leitstand {

/// Draws @p overlay over the picture that fills @p picture. The pane's head ends at @p top [px].
void paintCameraOverlay(QPainter& painter, const QRectF& picture, double top, const CameraOverlay& overlay);

/// Returns the dark theme's colours. Overlays use them in every theme, since pictures do not follow the
/// theme.
[[nodiscard]] const ThemeColours& overlayInks();
/// Draws @p shape in @p colour with a dark rim.
void strokeRimmed(QPainter& painter, const QPainterPath& shape, const QColor& colour, double width,
                  Qt::PenStyle style = Qt::SolidLine);
/// Paints @p text with a dark rim, legible on any picture, into @p box. @p flags: of Qt::AlignmentFlag.
void paintRimmedText(QPainter& painter, const QRectF& box, int flags, const QString& text,
                     const QColor& colour);

}  // namespace leitstand
