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

/// Keys that drive or stop, whatever a layout says: the usual ones, and those that the files of @p robots
/// bind.
[[nodiscard]] std::vector<Qt::Key> drivingKeys(const std::vector<RobotDescription>& robots);

/// Who has the sticks: the one place that decides between keys and gamepad. Keys drive in an explicit drive
/// focus: forward, back, left, right as the robot's file binds them (W S A D) or by the arrows; Shift is
/// slow, Ctrl fast. While the gamepad's trigger is held the pad drives, with or without that focus, and keys
/// do nothing; then whatever is held has to be pressed anew. Space lets everything go, G, while it is held,
/// drives without eyes. A field that is written into ends the focus of the keys; all ends when the window
/// loses the keyboard; a pane that floats beside it is of the window for the gamepad, not for keys.
class DriveInput final : public QObject {
    Q_OBJECT
public:
    /// Watches keys of @p window and of what is in it.
    explicit DriveInput(QWidget& window);

    /// Whose keys and limits count; ends the focus.
    void setRobot(const RobotDescription& robot);
    [[nodiscard]] bool hasFocus() const { return m_focus || m_pad; }  ///< of keys or gamepad
    [[nodiscard]] bool keysHaveFocus() const { return m_focus; }
    void setFocus(bool focus);  ///< of the keys; without it the pad has to let go too
    /// The gamepad's sticks; @p driving: its trigger is held and counts.
    void setPad(const DriveVelocity& velocity, bool driving, bool withoutEyes = false);
    /// The override of the speed cap is held, on keyboard or gamepad.
    [[nodiscard]] bool withoutEyes() const { return m_withoutEyes || m_padWithoutEyes; }

    bool eventFilter(QObject* watched, QEvent* event) override;

signals:
    /// Of hasFocus(), or of keysHaveFocus() alone.
    void focusChanged(bool focus);
    /// The sticks as they are: with every change, and fifty times a second while keys have the focus.
    void sticks(const leitstand::DriveVelocity& velocity);
    void halted();  ///< Space
    /// What the gamepad holds counts no more: its trigger and sticks have to be let go first.
    void padMustLetGo();
    /// A letter that drives was pressed while the keys do not.
    void pressedInVain();

private:
    /// Whether the key is one of driving, and was taken.
    bool take(const QKeyEvent& event, bool held);
    [[nodiscard]] bool isTaken(int key) const;
    [[nodiscard]] bool isInVain(const QWidget& widget, const QKeyEvent& event) const;
    /// The key that went down there: modifiers that come and go meanwhile change what a release is called.
    int keyOf(const QKeyEvent& event, bool held);
    void take(bool keys, bool pad);  ///< who has the sticks from now on

    QWidget& m_window;
    std::map<int, DriveKey> m_bindings;   ///< by Qt::Key
    std::map<std::uint32_t, int> m_down;  ///< Qt::Key by the keyboard's own code, of what is held
    DriveLimits m_limits;
    DriveKeys m_keys;
    QTimer m_rhythm;
    bool m_focus = false, m_pad = false, m_withoutEyes = false, m_padWithoutEyes = false;
    bool m_gear = false;    ///< Shift or Ctrl is held
    bool m_geared = false;  ///< likewise, and the robot was moved by it
};

}  // namespace leitstand
