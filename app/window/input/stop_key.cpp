#include "app/window/input/stop_key.h"

#include <QApplication>
#include <QKeyEvent>

namespace leitstand {

StopKey::StopKey(QObject* parent) : QObject(parent) {
    qApp->installEventFilter(this);
}

bool StopKey::eventFilter(QObject*, QEvent* event) {
    const bool asked = event->type() == QEvent::ShortcutOverride;
    if (!asked && event->type() != QEvent::KeyPress) return false;
    const auto& key = static_cast<const QKeyEvent&>(*event);
    if (key.key() != Qt::Key_Escape) return false;
    event->accept();
    // One press passes several objects; the first one handles it.
    if (!asked && !key.isAutoRepeat()) emit pressed();
    return true;
}

}  // namespace leitstand
