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

/// Returns the keys that drive or stop in any layout: the default keys, and those in the files of @p robots.
/// They include Esc, Space and G, but not Shift and Ctrl.
[[nodiscard]] std::vector<Qt::Key> drivingKeys(const std::vector<RobotDescription>& robots);

/// Decides whether keys or the gamepad drive the robot; nothing else does.
///
/// Keys drive only while they have the drive focus: W S A D, the arrows, and the keys in the robot's file.
/// Shift is slow, Ctrl fast. While the gamepad's trigger is held, the pad drives, with or without that focus,
/// and keys do nothing. After the trigger is released, keys that are still held must be pressed again. Space
/// halts the robot and releases keys and pad. While G is held, old pictures do not limit the speed.
///
/// The drive focus of the keys ends when a text field gets the keyboard, or when a floating pane of the
/// window gets it. When the window loses the keyboard, both keys and pad stop driving.
class DriveInput final : public QObject {
    Q_OBJECT
public:
    /// Watches the keys of @p window and of the widgets in it.
    explicit DriveInput(QWidget& window);

    /// Sets the robot whose keys and limits are used. Ends the focus.
    void setRobot(const RobotDescription& robot);
    [[nodiscard]] bool hasFocus() const { return m_focus || m_pad; }  ///< whether keys or gamepad drive
    [[nodiscard]] bool keysHaveFocus() const { return m_focus; }
    /// Drive focus of the keys; false also disables the pad until its trigger is released.
    void setFocus(bool focus);
    /// Takes the positions of the gamepad's sticks. @p driving: its trigger is held and accepted.
    /// @p withoutEyes: its override of the speed limit is held.
    void setPad(const DriveVelocity& velocity, bool driving, bool withoutEyes = false);
    /// Returns whether the override of the speed limit is held, on keyboard or gamepad.
    [[nodiscard]] bool withoutEyes() const { return m_withoutEyes || m_padWithoutEyes; }

    bool eventFilter(QObject* watched, QEvent* event) override;

signals:
    /// hasFocus() or keysHaveFocus() changed. @p focus: hasFocus().
    void focusChanged(bool focus);
    /// The velocity that keys or gamepad request: emitted at every change, and at 50 Hz while the keys have
    /// the focus and the pad does not drive.
    void sticks(const leitstand::DriveVelocity& velocity);
    void halted();  ///< Space was pressed
    /// The gamepad no longer drives, even if its trigger is held: trigger and sticks must be released first.
    void padMustLetGo();
    /// A key that drives was pressed without the drive focus.
    void pressedInVain();

private:
    /// Returns whether the key is used for driving and was handled.
    bool take(const QKeyEvent& event, bool held);
    [[nodiscard]] bool isTaken(int key) const;
    [[nodiscard]] bool isInVain(const QWidget& widget, const QKeyEvent& event) const;
    /// Returns the key of @p event as it was when it was pressed, since modifiers pressed later change the
    /// key in a release event.
    int keyOf(const QKeyEvent& event, bool held);
    void take(bool keys, bool pad);  ///< sets whether keys or pad drive

    QWidget& m_window;
    std::map<int, DriveKey> m_bindings;   ///< by Qt::Key
    std::map<std::uint32_t, int> m_down;  ///< keys that are held: native scan code -> Qt::Key
    DriveLimits m_limits;
    DriveKeys m_keys;
    QTimer m_rhythm;
    bool m_focus = false, m_pad = false, m_withoutEyes = false, m_padWithoutEyes = false;
    bool m_gear = false;    ///< Shift or Ctrl is held
    bool m_geared = false;  ///< whether Shift or Ctrl is held, and the robot has moved while it was
};

}  // namespace leitstand
