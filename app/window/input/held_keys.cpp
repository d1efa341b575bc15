#include "app/window/input/held_keys.h"

#include <utility>

#include <QApplication>
#include <QKeyEvent>
#include <QWidget>

#include "app/window/input/worked_in.h"

namespace leitstand {

HeldKeys::HeldKeys(QWidget& window, Meaning meaning, std::function<bool()> driving)
    : m_window(window), m_meaning(std::move(meaning)), m_driving(std::move(driving)) {
    qApp->installEventFilter(this);
}

bool HeldKeys::isOurs(const QKeyEvent& event) const {
    if (!m_meaning(event)) return false;
    const auto others = event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier);
    return !others || (others == Qt::ControlModifier && m_driving());
}

bool HeldKeys::take(const QKeyEvent& event, bool held) {
    const int meaning = *m_meaning(event);
    if (event.isAutoRepeat()) return true;
    m_shift = event.modifiers().testFlag(Qt::ShiftModifier);
    if (held) {
        m_held.insert(meaning);
        emit pressed(meaning);
    } else {
        m_held.erase(meaning);
    }
    emit changed();
    return true;
}

void HeldKeys::letGo() {
    if (m_held.empty()) return;
    m_held.clear();
    emit changed();
}

bool HeldKeys::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
        case QEvent::ShortcutOverride:
        case QEvent::KeyPress:
        case QEvent::KeyRelease: {
            const auto* widget = qobject_cast<QWidget*>(watched);
            if (widget == nullptr) return false;
            auto& key = static_cast<QKeyEvent&>(*event);
            if (event->type() == QEvent::KeyRelease) {
                const auto meaning = m_meaning(key);
                return meaning && m_held.contains(*meaning) && take(key, false);
            }
            if (widget->window() != &m_window) return false;
            if (!isOurs(key) || isWrittenInto(*widget)) return false;
            if (event->type() == QEvent::KeyPress) return take(key, true);
            event->accept();
            return true;
        }
        case QEvent::WindowDeactivate:
            if (watched == &m_window) letGo();
            return false;
        default:
            return false;
    }
}

}  // namespace leitstand
