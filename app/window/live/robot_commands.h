#pragma once

#include <functional>

#include <QObject>

class QAction;
class QMenu;
class QWidget;

namespace leitstand {

class LiveBridge;

/// What the operator asks of robots: the Robot menu.
class RobotCommands final : public QObject {
    Q_OBJECT
public:
    RobotCommands(LiveBridge& bridge, QWidget& window);

    /// Puts the commands into @p menu; @p selected tells the robot that modes are asked of.
    void fill(QMenu& menu, std::function<QString()> selected);
    void showDriving(bool driving);

signals:
    void selected(const QString& robot);
    void drivingWanted(bool on);
    void swapWanted();
    void rightViewWanted();
    void failed(const QString& why);

private:
    void fillModes(QMenu& modes, const QString& robot);

    LiveBridge& m_bridge;
    QAction *m_drive, *m_stop, *m_swap, *m_right;
};

}  // namespace leitstand
