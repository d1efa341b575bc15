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

/// The key itself: what it means may change while it is held, by a modifier or another robot.
std::uint64_t HeldKeys::keyOf(const QKeyEvent& event) {
    constexpr std::uint64_t ByName = std::uint64_t{1} << 32U;
    if (event.nativeScanCode() != 0) return event.nativeScanCode();
    return ByName + static_cast<std::uint32_t>(event.key());
}

void HeldKeys::press(const QKeyEvent& event) {
    if (event.isAutoRepeat()) return;
    const int meaning = *m_meaning(event);
    m_shift = event.modifiers().testFlag(Qt::ShiftModifier);
    m_down.insert_or_assign(keyOf(event), meaning);
    m_held.insert(meaning);
    emit pressed(meaning);
    emit changed();
}

bool HeldKeys::release(const QKeyEvent& event) {
    const auto key = m_down.find(keyOf(event));
    if (key == m_down.end()) return false;
    if (event.isAutoRepeat()) return true;
    m_shift = event.modifiers().testFlag(Qt::ShiftModifier);
    m_down.erase(key);
    m_held.clear();
    for (const auto& [other, meaning] : m_down) m_held.insert(meaning);
    emit changed();
    return true;
}

void HeldKeys::letGo() {
    m_down.clear();
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
            if (event->type() == QEvent::KeyRelease) return release(key);
            if (widget->window() != &m_window) return false;
            if (!isOurs(key) || isWrittenInto(*widget)) return false;
            if (event->type() == QEvent::KeyPress) {
                press(key);
            } else {
                event->accept();
            }
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
