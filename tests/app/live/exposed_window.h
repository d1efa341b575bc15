#pragma once

#include <QApplication>
#include <QWindow>

#include "app/window/live/live_window.h"

namespace leitstand::test {

/// The live window that is on the screen; null: there is none.
[[nodiscard]] inline LiveWindow* exposedWindow() {
    for (QWidget* widget : QApplication::topLevelWidgets()) {
        auto* const window = qobject_cast<LiveWindow*>(widget);
        if (window != nullptr && window->windowHandle() != nullptr && window->windowHandle()->isExposed())
            return window;
    }
    return nullptr;
}

}  // namespace leitstand::test
