#pragma once

#include <QByteArray>
#include <QMargins>
#include <QRect>
#include <QSize>

class QWidget;

namespace leitstand {

/// Geometry of a window that is shown for the first time.
struct FirstGeometry {
    QRect inside;            ///< the window without its frame; if maximised, its normal geometry
    bool maximised = false;  ///< whether it is shown maximised
};

/// Returns a geometry in the middle of @p available, the usable part of a screen. Its size is @p usual, or
/// smaller if that does not fit with a @p frame around it. Maximised if the screen is larger than @p usual.
[[nodiscard]] FirstGeometry firstGeometry(const QRect& available, const QMargins& frame, QSize usual);

/// Shows @p window as it was last; @p left is from QWidget::saveGeometry(). The first time (@p left is empty
/// or not valid), places it with firstGeometry() on its screen.
void showAsLeft(QWidget& window, const QByteArray& left, QSize usual);

}  // namespace leitstand
