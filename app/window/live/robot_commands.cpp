#include "app/window/live/robot_commands.h"

#include <utility>

#include <QAction>
#include <QMenu>

#include "app/window/commands/make_action.h"
#include "app/window/live/live_bridge.h"
#include "core/mission/mission_state.h"
#include "widgets/models/live/mode_label.h"

namespace leitstand {

RobotCommands::RobotCommands(LiveBridge& bridge, QWidget& window)
    : QObject(&window),
      m_bridge(bridge),
      m_drive(makeAction({.name = "drive",
                          .text = tr("&Drive with keys"),
                          .hint = tr("W S A D or the arrows drive the selected robot; Shift slow, Ctrl fast, "
                                     "Space lets go"),
                          .keys = QKeySequence(Qt::Key_F2),
                          .checkable = true},
                         this)),
      m_stop(makeAction({.name = "stop",
                         .text = tr("&Stop all robots\tEsc"),
                         .hint = tr("All robots stand until each is released")},
                        this)),
      m_swap(makeAction({.name = "swapViews",
                         .text = tr("S&wap camera and map"),
                         .hint = tr("Camera and map change places"),
                         .keys = QKeySequence(Qt::Key_X)},
                        this)),
      m_right(makeAction({.name = "rightView",
                          .text = tr("&Next small picture"),
                          .hint = tr("Shows the next camera of the robot in the small pane"),
                          .keys = QKeySequence(Qt::Key_I)},
                         this)) {
    connect(m_drive, &QAction::triggered, this, &RobotCommands::drivingWanted);
    connect(m_stop, &QAction::triggered, this, [this] { m_bridge.station().stopAll(); });
    connect(m_swap, &QAction::triggered, this, &RobotCommands::swapWanted);
    connect(m_right, &QAction::triggered, this, &RobotCommands::rightViewWanted);
}

void RobotCommands::showDriving(bool driving) {
    m_drive->setChecked(driving);
}

void RobotCommands::fill(QMenu& menu, std::function<QString()> selectedRobot) {
    int number = 1;
    for (const RobotDescription& robot : m_bridge.station().robots()) {
        const QString name = QString::fromStdString(robot.name), title = QString::fromStdString(robot.title);
        // The key is the robot bar's.
        QAction* one = makeAction({.name = "select",
                                   .text = tr("Select %1\t%2").arg(title).arg(number++),
                                   .hint = tr("Select %1").arg(title)},
                                  this);
        connect(one, &QAction::triggered, this, [this, name] { emit selected(name); });
        menu.addAction(one);
    }
    menu.addSeparator();
    menu.addAction(m_drive);
    menu.addAction(m_stop);
    QMenu* modes = menu.addMenu(tr("&Mode"));
    connect(modes, &QMenu::aboutToShow, this,
            [this, modes, robot = std::move(selectedRobot)] { fillModes(*modes, robot()); });
    menu.addSeparator();
    menu.addActions({m_swap, m_right});
}

void RobotCommands::fillModes(QMenu& modes, const QString& robot) {
    modes.clear();
    const MissionStatePtr mission = m_bridge.station().mission();
    const auto said = mission->robots.find(robot.toStdString());
    if (said == mission->robots.end() || !said->second->mode) {
        modes.addAction(tr("The robot has told none yet"))->setEnabled(false);
        return;
    }
    const ModeSample& now = said->second->mode->sample;
    for (const std::string& mode : now.available) {
        QAction* one = modes.addAction(modeName(mode));
        one->setCheckable(true);
        one->setChecked(mode == now.mode);
        connect(one, &QAction::triggered, this, [this, robot, mode] {
            m_bridge.station().ask(robot.toStdString());
            if (const auto asked = m_bridge.station().setMode(robot.toStdString(), mode); !asked)
                emit failed(QString::fromStdString(asked.error().text));
        });
    }
}

}  // namespace leitstand
