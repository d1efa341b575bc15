#pragma once

#include <QPainter>
#include <QRectF>

#include "widgets/camera/camera_pane.h"

namespace leitstand {

/// Paints where the camera looks: a line with a mark and words at the lower edge of @p picture. Beside it,
/// the body from above with the camera's field of view.
void paintPan(QPainter& painter, const QRectF& picture, const CameraOverlay& overlay);

/// Returns the upper edge of the words of paintPan() [px]; the lower edge of @p picture when there are none.
[[nodiscard]] double panWordsTop(const QRectF& picture, const CameraOverlay& overlay);
/// Returns where paintPan() draws the body from above.
[[nodiscard]] QRectF panMarkArea(const QRectF& picture);

}  // namespace leitstand
