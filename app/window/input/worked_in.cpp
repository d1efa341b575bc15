#include "app/window/input/worked_in.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QDockWidget>

namespace leitstand {

bool isWorkedIn(const QWidget& window) {
    const QWidget* const active = QApplication::activeWindow();
    if (active == &window) return true;
    if (qobject_cast<const QDockWidget*>(active) == nullptr) return false;
    // A floating pane is a window of its own, at which isAncestorOf() stops.
    for (const QWidget* owner = active->parentWidget(); owner != nullptr; owner = owner->parentWidget()) {
        if (owner == &window) return true;
    }
    return false;
}

bool isWrittenInto(const QWidget& widget) {
    // Lists have the attribute until they first get the keyboard. The editor of a cell is a field itself.
    return widget.testAttribute(Qt::WA_InputMethodEnabled) &&
           qobject_cast<const QAbstractItemView*>(&widget) == nullptr;
}

}  // namespace leitstand
