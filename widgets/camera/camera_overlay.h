#pragma once

#include <QPainter>
#include <QPainterPath>
#include <QRectF>

#include "widgets/camera/camera_pane.h"

namespace leitstand {

/// Draws @p overlay over a picture that lies in @p picture, of a pane whose head ends at @p top.
void paintCameraOverlay(QPainter& painter, const QRectF& picture, double top, const CameraOverlay& overlay);

/// Pictures are dark or bright whatever the theme: what is drawn over them has the dark theme's colours.
[[nodiscard]] const ThemeColours& overlayInks();
/// Draws @p shape in @p colour with a dark rim.
void strokeRimmed(QPainter& painter, const QPainterPath& shape, const QColor& colour, double width,
                  Qt::PenStyle style = Qt::SolidLine);
/// @p text with a dark rim, legible on any picture, in the middle of @p box or as @p flags say.
void paintRimmedText(QPainter& painter, const QRectF& box, int flags, const QString& text,
                     const QColor& colour);

}  // namespace leitstand
