#pragma once

#include <QByteArray>
#include <QMargins>
#include <QRect>
#include <QSize>

class QWidget;

namespace leitstand {

/// How a window is shown for the first time.
struct FirstGeometry {
    QRect inside;            ///< of the window without its frame
    bool maximised = false;  ///< and what it has when it is not maximised any more
};

/// In the middle of a screen of which windows may use @p available: of @p usual size, smaller where that does
/// not fit with a @p frame around it; maximised where more fits.
[[nodiscard]] FirstGeometry firstGeometry(const QRect& available, const QMargins& frame, QSize usual);

/// Shows @p window as it was left, as QWidget::saveGeometry() told; for the first time (@p left is empty, or
/// tells nothing) by firstGeometry() on its screen.
void showAsLeft(QWidget& window, const QByteArray& left, QSize usual);

}  // namespace leitstand
