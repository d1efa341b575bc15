#include "app/window/input/drive_input.h"

#include <chrono>

#include <QApplication>
#include <QKeyEvent>
#include <QKeySequence>
#include <QWidget>

#include "app/window/input/worked_in.h"

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

/// Returns the keys that the file of @p robot binds. Escape, Space and G always stop, halt and lift the cap.
std::map<int, DriveKey> ownKeys(const RobotDescription& robot) {
    std::map<int, DriveKey> keys;
    for (const auto& [action, name] : robot.bindings) {
        const auto known = actions().find(action);
        const QKeySequence sequence(QString::fromStdString(name));
        if (known == actions().end() || sequence.count() != 1) continue;
        const int key = sequence[0].key();
        if (key != Qt::Key_Escape && key != Qt::Key_Space && key != OverrideKey) keys[key] = known->second;
    }
    return keys;
}

}  // namespace

std::vector<Qt::Key> drivingKeys(const std::vector<RobotDescription>& robots) {
    std::vector<Qt::Key> all = {Qt::Key_Escape, Qt::Key_Space, static_cast<Qt::Key>(OverrideKey)};
    const auto add = [&all](const std::map<int, DriveKey>& keys) {
        for (const auto& [key, meaning] : keys) {
            // Slow and fast are held together with other keys.
            if (meaning != DriveKey::Slow && meaning != DriveKey::Fast)
                all.push_back(static_cast<Qt::Key>(key));
        }
    };
    add(usualKeys());
    for (const RobotDescription& robot : robots) add(ownKeys(robot));
    return all;
}

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
    for (const auto& [key, meaning] : ownKeys(robot)) m_bindings[key] = meaning;
}

void DriveInput::take(bool keys, bool pad) {
    m_keys.releaseAll();
    m_down.clear();
    m_gear = m_geared = false;
    if (keys == m_focus && pad == m_pad) return;
    const bool padEnds = m_pad && !pad;
    m_focus = keys;
    m_pad = pad;
    if (!hasFocus()) m_withoutEyes = false;
    if (!m_pad) m_padWithoutEyes = false;
    if (m_focus && !m_pad) {
        m_rhythm.start();
    } else {
        m_rhythm.stop();
    }
    if (padEnds || !hasFocus()) emit sticks({});
    emit focusChanged(hasFocus());
}

void DriveInput::setFocus(bool focus) {
    const bool padHad = m_pad;
    // A text field gives up the keyboard: from now on letters drive.
    QWidget* const field = QApplication::focusWidget();
    if (focus && field != nullptr && field->window() == &m_window && isWrittenInto(*field))
        field->clearFocus();
    take(focus, focus && m_pad);
    if (padHad && !m_pad) emit padMustLetGo();
}

void DriveInput::setPad(const DriveVelocity& velocity, bool driving, bool withoutEyes) {
    m_padWithoutEyes = driving && withoutEyes;
    if (driving != m_pad) take(m_focus, driving);
    if (m_pad) emit sticks(velocity);
}

bool DriveInput::isTaken(int key) const {
    return key == Qt::Key_Space || key == OverrideKey || (m_focus && m_bindings.contains(key));
}

int DriveInput::keyOf(const QKeyEvent& event, bool held) {
    const std::uint32_t code = event.nativeScanCode();
    if (code == 0 || event.isAutoRepeat()) return event.key();
    if (held) return m_down[code] = event.key();
    const auto down = m_down.find(code);
    if (down == m_down.end()) return event.key();
    const int key = down->second;
    m_down.erase(down);
    return key;
}

bool DriveInput::take(const QKeyEvent& event, bool held) {
    const int key = keyOf(event, held);
    if (!isTaken(key)) return false;
    if (key == Qt::Key_Space) {
        const bool padHad = m_pad;
        if (held && !event.isAutoRepeat()) {
            emit halted();  // while the robot still has the sticks
            take(m_focus, false);
            if (padHad) emit padMustLetGo();
        }
        return true;
    }
    if (key == OverrideKey) {
        if (!event.isAutoRepeat()) m_withoutEyes = held;
        return true;
    }
    if (event.isAutoRepeat() || m_pad) return true;
    m_keys.set(m_bindings.at(key), held);
    const bool gear = m_bindings.at(key) == DriveKey::Slow || m_bindings.at(key) == DriveKey::Fast;
    if (gear) m_gear = held;
    m_geared = (m_geared || m_keys.any()) && m_gear;
    emit sticks(m_keys.sticks(m_limits));
    return true;
}

bool DriveInput::isInVain(const QWidget& widget, const QKeyEvent& event) const {
    const bool letter = event.key() >= Qt::Key_A && event.key() <= Qt::Key_Z;
    return letter && m_bindings.contains(event.key()) && event.modifiers() == Qt::NoModifier &&
           !event.isAutoRepeat() && widget.window() == &m_window && !isWrittenInto(widget);
}

bool DriveInput::eventFilter(QObject* watched, QEvent* event) {
    if (!hasFocus()) {
        const auto* const widget = qobject_cast<QWidget*>(watched);
        if (event->type() == QEvent::KeyPress && widget != nullptr &&
            isInVain(*widget, static_cast<const QKeyEvent&>(*event)))
            emit pressedInVain();
        return false;
    }
    switch (event->type()) {
        case QEvent::KeyPress:
        case QEvent::KeyRelease: {
            const auto* widget = qobject_cast<QWidget*>(watched);
            if (widget == nullptr) return false;
            if (isWrittenInto(*widget)) {
                // A key that was held before and is released there counts as released. The field also gets
                // the event.
                if (event->type() == QEvent::KeyRelease) take(static_cast<const QKeyEvent&>(*event), false);
                return false;
            }
            if (widget->window() != &m_window) {
                // A menu opened meanwhile has the keyboard: a key released there counts as released.
                if (event->type() == QEvent::KeyRelease) take(static_cast<const QKeyEvent&>(*event), false);
                return false;
            }
            return take(static_cast<const QKeyEvent&>(*event), event->type() == QEvent::KeyPress);
        }
        case QEvent::ShortcutOverride: {
            // Letters that drive are no shortcuts meanwhile. While a key moves the robot, shortcuts with
            // Shift and Ctrl, which are slow and fast, are none either. A follow key with "fast" held must
            // not undo anything.
            const auto* widget = qobject_cast<QWidget*>(watched);
            if (widget != nullptr && isWrittenInto(*widget)) return false;
            const auto& key = static_cast<const QKeyEvent&>(*event);
            const bool geared =
                (m_keys.any() || m_geared) && (key.modifiers() & (Qt::ShiftModifier | Qt::ControlModifier));
            if (key.key() == Qt::Key_Escape || (!isTaken(key.key()) && !geared)) return false;
            event->accept();
            return true;
        }
        case QEvent::FocusIn: {
            // Letters typed into a field do not drive. The gamepad continues to drive.
            const auto* widget = qobject_cast<QWidget*>(watched);
            if (widget == nullptr || widget->window() != &m_window || !isWrittenInto(*widget)) return false;
            m_withoutEyes = false;  // its key is a letter now
            take(false, m_pad);
            return false;
        }
        case QEvent::WindowDeactivate:
            if (watched != &m_window) return false;
            // Keys follow the keyboard. A gamepad continues to drive beside a floating pane.
            isWorkedIn(m_window) ? take(false, m_pad) : setFocus(false);
            return false;
        case QEvent::ApplicationStateChange:
            if (QApplication::applicationState() != Qt::ApplicationActive) setFocus(false);
            return false;
        default:
            return false;
    }
}

}  // namespace leitstand
