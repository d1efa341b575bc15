#include "app/window/shell/first_geometry.h"

#include <QGuiApplication>
#include <QScreen>
#include <QWidget>

namespace leitstand {
namespace {

/// A title bar and borders as desktops draw them. The real ones are unknown before a window is shown.
constexpr QMargins UsualFrame(8, 40, 8, 8);

}  // namespace

FirstGeometry firstGeometry(const QRect& available, const QMargins& frame, QSize usual) {
    const QRect most = available.marginsRemoved(frame);
    const QSize size = usual.boundedTo(most.size());
    QRect inside(QPoint(), size);
    inside.moveCenter(most.center());
    const bool more = most.width() > usual.width() || most.height() > usual.height();
    return {inside, more};
}

void showAsLeft(QWidget& window, const QByteArray& left, QSize usual) {
    if (left.isEmpty() || !window.restoreGeometry(left)) {
        const FirstGeometry first = firstGeometry(window.screen()->availableGeometry(), UsualFrame, usual);
        window.setGeometry(first.inside);
        if (first.maximised) return window.showMaximized();
    }
    window.show();
}

}  // namespace leitstand
