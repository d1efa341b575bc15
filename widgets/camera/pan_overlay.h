#pragma once

#include <QPainter>
#include <QRectF>

#include "widgets/camera/camera_pane.h"

namespace leitstand {

/// Paints where the camera looks. At the lower edge of @p picture there is a line with a mark, and words.
/// Beside them is the robot from above, with the camera's field of view. Pictures narrower than 320 px only
/// show the robot.
void paintPan(QPainter& painter, const QRectF& picture, const CameraOverlay& overlay);

/// Returns the upper edge of the words of paintPan() [px]; without words, the lower edge of @p picture.
[[nodiscard]] double panWordsTop(const QRectF& picture, const CameraOverlay& overlay);
/// Returns where paintPan() draws the robot from above.
[[nodiscard]] QRectF panMarkArea(const QRectF& picture);

}  // namespace leitstand
