#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include <QObject>
#include <QTimer>

#include "core/robot/control/drive_keys.h"
#include "core/robot/robot_description.h"

class QKeyEvent;
class QWidget;

namespace leitstand {

/// Returns the keys that drive or stop in any layout: the default keys, and those that the files of @p robots
/// bind. They include Esc, Space and G, but not Shift and Ctrl.
[[nodiscard]] std::vector<Qt::Key> drivingKeys(const std::vector<RobotDescription>& robots);

/// Decides whether keys or the gamepad drive the robot; nothing else does. Keys drive only while they have
/// the drive focus: W S A D, the arrows, and the keys that the robot's file binds. Shift is slow, Ctrl fast.
/// While the gamepad's trigger is held, the pad drives, with or without that focus, and keys do nothing. When
/// the trigger is released, keys that are still held must be pressed again. Space halts the robot and
/// releases keys and pad. While G is held, old pictures do not cap the speed. A text field that gets the
/// keyboard ends the focus of the keys. When the window loses the keyboard, keys and pad both end; when one
/// of its floating panes gets it, only the keys.
class DriveInput final : public QObject {
    Q_OBJECT
public:
    /// Watches the keys of @p window and of the widgets in it.
    explicit DriveInput(QWidget& window);

    /// Sets the robot whose keys and limits count. Ends the focus.
    void setRobot(const RobotDescription& robot);
    [[nodiscard]] bool hasFocus() const { return m_focus || m_pad; }  ///< of keys or gamepad
    [[nodiscard]] bool keysHaveFocus() const { return m_focus; }
    void setFocus(bool focus);  ///< of the keys; false also disables the pad until its trigger is released
    /// Takes the positions of the gamepad's sticks. @p driving: its trigger is held and counts.
    /// @p withoutEyes: its override of the speed cap is held.
    void setPad(const DriveVelocity& velocity, bool driving, bool withoutEyes = false);
    /// Returns whether the override of the speed cap is held, on keyboard or gamepad.
    [[nodiscard]] bool withoutEyes() const { return m_withoutEyes || m_padWithoutEyes; }

    bool eventFilter(QObject* watched, QEvent* event) override;

signals:
    /// hasFocus() or keysHaveFocus() changed. @p focus is hasFocus().
    void focusChanged(bool focus);
    /// The velocity that keys or gamepad request: at every change, and at 50 Hz while the keys have the focus
    /// and the pad does not drive.
    void sticks(const leitstand::DriveVelocity& velocity);
    void halted();  ///< Space was pressed
    /// The gamepad no longer drives, even if its trigger is held: trigger and sticks must be released first.
    void padMustLetGo();
    /// A letter that drives was pressed without the drive focus.
    void pressedInVain();

private:
    /// Returns whether the key belongs to driving and was consumed.
    bool take(const QKeyEvent& event, bool held);
    [[nodiscard]] bool isTaken(int key) const;
    [[nodiscard]] bool isInVain(const QWidget& widget, const QKeyEvent& event) const;
    /// Returns the key that @p event is about, as it was when it went down: modifiers pressed meanwhile
    /// change the key of a release event.
    int keyOf(const QKeyEvent& event, bool held);
    void take(bool keys, bool pad);  ///< sets who has the sticks

    QWidget& m_window;
    std::map<int, DriveKey> m_bindings;   ///< by Qt::Key
    std::map<std::uint32_t, int> m_down;  ///< held keys: Qt::Key by native scan code
    DriveLimits m_limits;
    DriveKeys m_keys;
    QTimer m_rhythm;
    bool m_focus = false, m_pad = false, m_withoutEyes = false, m_padWithoutEyes = false;
    bool m_gear = false;    ///< Shift or Ctrl is held
    bool m_geared = false;  ///< Shift or Ctrl is held, and the robot was moved meanwhile
};

}  // namespace leitstand
