#include "app/window/input/worked_in.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QDockWidget>

namespace leitstand {

bool isWorkedIn(const QWidget& window) {
    const QWidget* const active = QApplication::activeWindow();
    if (active == &window) return true;
    if (qobject_cast<const QDockWidget*>(active) == nullptr) return false;
    // A pane that floats is a window of its own: isAncestorOf() does not look beyond.
    for (const QWidget* owner = active->parentWidget(); owner != nullptr; owner = owner->parentWidget()) {
        if (owner == &window) return true;
    }
    return false;
}

bool isWrittenInto(const QWidget& widget) {
    // Lists have the attribute until they get the keyboard for the first time; what edits a cell is a field
    // itself.
    return widget.testAttribute(Qt::WA_InputMethodEnabled) &&
           qobject_cast<const QAbstractItemView*>(&widget) == nullptr;
}

}  // namespace leitstand
