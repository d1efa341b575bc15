#include "app/window/live/drive_input.h"

#include <chrono>

#include <QApplication>
#include <QKeyEvent>
#include <QKeySequence>
#include <QWidget>

namespace leitstand {
namespace {

constexpr std::chrono::milliseconds Rhythm(20);
constexpr int OverrideKey = Qt::Key_G;

const std::map<std::string, DriveKey>& actions() {
    static const std::map<std::string, DriveKey> all = {{"forward", DriveKey::Forward},
                                                        {"back", DriveKey::Back},
                                                        {"left", DriveKey::Left},
                                                        {"right", DriveKey::Right}};
    return all;
}

std::map<int, DriveKey> usualKeys() {
    return {{Qt::Key_W, DriveKey::Forward},  {Qt::Key_S, DriveKey::Back},
            {Qt::Key_A, DriveKey::Left},     {Qt::Key_D, DriveKey::Right},
            {Qt::Key_Up, DriveKey::Forward}, {Qt::Key_Down, DriveKey::Back},
            {Qt::Key_Left, DriveKey::Left},  {Qt::Key_Right, DriveKey::Right},
            {Qt::Key_Shift, DriveKey::Slow}, {Qt::Key_Control, DriveKey::Fast}};
}

}  // namespace

DriveInput::DriveInput(QWidget& window) : QObject(&window), m_window(window), m_bindings(usualKeys()) {
    m_rhythm.setInterval(Rhythm);
    m_rhythm.setTimerType(Qt::PreciseTimer);
    connect(&m_rhythm, &QTimer::timeout, this, [this] { emit sticks(m_keys.sticks(m_limits)); });
    qApp->installEventFilter(this);
}

void DriveInput::setRobot(const RobotDescription& robot) {
    setFocus(false);
    m_limits = limitsOf(robot);
    m_bindings = usualKeys();
    for (const auto& [action, name] : robot.bindings) {
        const auto known = actions().find(action);
        const QKeySequence sequence(QString::fromStdString(name));
        if (known == actions().end() || sequence.count() != 1) continue;
        m_bindings[sequence[0].key()] = known->second;
    }
}

void DriveInput::setFocus(bool focus) {
    m_keys.releaseAll();
    m_withoutEyes = false;
    if (focus == m_focus) return;
    m_focus = focus;
    if (focus) {
        m_rhythm.start();
    } else {
        m_rhythm.stop();
        emit sticks({});
    }
    emit focusChanged(focus);
}

bool DriveInput::take(const QKeyEvent& event, bool held) {
    if (event.key() == Qt::Key_Space) {
        if (held && !event.isAutoRepeat()) {
            m_keys.releaseAll();
            emit halted();
        }
        return true;
    }
    if (event.key() == OverrideKey) {
        if (!event.isAutoRepeat()) m_withoutEyes = held;
        return true;
    }
    const auto bound = m_bindings.find(event.key());
    if (bound == m_bindings.end()) return false;
    if (!event.isAutoRepeat()) m_keys.set(bound->second, held);
    return true;
}

bool DriveInput::eventFilter(QObject* watched, QEvent* event) {
    if (!m_focus) return false;
    switch (event->type()) {
        case QEvent::KeyPress:
        case QEvent::KeyRelease: {
            const auto* widget = qobject_cast<QWidget*>(watched);
            if (widget == nullptr || widget->window() != &m_window) return false;
            return take(static_cast<const QKeyEvent&>(*event), event->type() == QEvent::KeyPress);
        }
        case QEvent::ShortcutOverride: {
            // Letters that drive are no shortcuts meanwhile.
            const auto& key = static_cast<const QKeyEvent&>(*event);
            if (key.key() != Qt::Key_Space && key.key() != OverrideKey && !m_bindings.contains(key.key()))
                return false;
            event->accept();
            return true;
        }
        case QEvent::WindowDeactivate:
            if (watched == &m_window) setFocus(false);
            return false;
        case QEvent::ApplicationStateChange:
            if (QApplication::applicationState() != Qt::ApplicationActive) setFocus(false);
            return false;
        default:
            return false;
    }
}

}  // namespace leitstand
