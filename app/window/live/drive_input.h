#pragma once

#include <functional>
#include <map>
#include <string>

#include <QObject>
#include <QTimer>

#include "core/robot/control/drive_keys.h"
#include "core/robot/robot_description.h"

class QKeyEvent;
class QWidget;

namespace leitstand {

/// Driving with keys, in an explicit drive focus: forward, back, left, right as the robot's file binds them
/// (W S A D) or by the arrows; Shift is slow, Ctrl fast, Space lets everything go, G, while it is held,
/// drives without eyes. The focus ends when the window loses the keyboard.
class DriveInput final : public QObject {
    Q_OBJECT
public:
    /// Watches keys of @p window and of what is in it.
    explicit DriveInput(QWidget& window);

    /// Whose keys and limits count; ends the focus.
    void setRobot(const RobotDescription& robot);
    [[nodiscard]] bool hasFocus() const { return m_focus; }
    void setFocus(bool focus);
    /// The override of the speed cap is held.
    [[nodiscard]] bool withoutEyes() const { return m_withoutEyes; }

    bool eventFilter(QObject* watched, QEvent* event) override;

signals:
    void focusChanged(bool focus);
    /// The sticks as they are; fifty times a second while there is focus.
    void sticks(const leitstand::DriveVelocity& velocity);
    void halted();  ///< Space

private:
    /// Whether the key is one of driving, and was taken.
    bool take(const QKeyEvent& event, bool held);

    QWidget& m_window;
    std::map<int, DriveKey> m_bindings;  ///< by Qt::Key
    DriveLimits m_limits;
    DriveKeys m_keys;
    QTimer m_rhythm;
    bool m_focus = false, m_withoutEyes = false;
};

}  // namespace leitstand
