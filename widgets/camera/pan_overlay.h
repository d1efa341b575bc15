#pragma once

#include <QPainter>
#include <QRectF>

#include "widgets/camera/camera_pane.h"

namespace leitstand {

/// Where the camera looks: a line with a mark and words at the lower edge of @p picture, and beside it the
/// body from above with the wedge that the camera sees.
void paintPan(QPainter& painter, const QRectF& picture, const CameraOverlay& overlay);

/// Where the line and the words of paintPan() begin [px]; the lower edge of @p picture where there are none.
[[nodiscard]] double panWordsTop(const QRectF& picture, const CameraOverlay& overlay);
/// Where paintPan() draws the body from above.
[[nodiscard]] QRectF panMarkArea(const QRectF& picture);

}  // namespace leitstand
