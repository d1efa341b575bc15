#include "app/window/robots/robots_feature.h"

#include <vector>

#include <QAction>
#include <QMainWindow>
#include <QMenu>

#include "app/services/station/station.h"
#include "app/window/commands/command_table.h"
#include "app/window/input/selection.h"
#include "app/window/input/stop_key.h"
#include "app/window/robots/service_menu.h"
#include "app/window/source/moment_source.h"
#include "core/event/status_samples.h"
#include "widgets/drive/stop_button.h"
#include "widgets/models/live/robots/robot_chip.h"
#include "widgets/models/live/texts/mode_label.h"
#include "widgets/models/live/texts/stop_line.h"
#include "widgets/models/others_text.h"
#include "widgets/robots/robot_bar.h"

namespace leitstand {

RobotsFeature::RobotsFeature(const ViewContext& context)
    : QObject(&context.window), m_context(context), m_bar(new RobotBar(&context.window)) {
    connect(m_bar, &RobotBar::robotSelected, &context.selection, &Selection::select);
    addChoice();
    if (context.liveStation != nullptr) {
        addStop(*context.liveStation);
        addCommands(*context.liveStation);
    }
    connect(&context.source, &MomentSource::ticked, this, &RobotsFeature::show);
}

void RobotsFeature::addStop(Station& station) {
    m_stop = new StopButton(&m_context.window);
    connect(m_stop, &StopButton::stopRequested, this, [&station] { station.stopAll(); });
    connect(m_bar, &RobotBar::releaseRequested, this, [this, &station](const QString& robot) {
        if (const auto let = station.release(robot.toStdString()); !let)
            m_context.notify(QString::fromStdString(let.error().text));
    });
    connect(new StopKey(&m_context.window), &StopKey::pressed, this, [&station] { station.stopAll(); });
}

QWidget* RobotsFeature::bar() const {
    return m_bar;
}

QWidget* RobotsFeature::stop() const {
    return m_stop;
}

void RobotsFeature::addChoice() {
    CommandTable& commands = m_context.commands;
    for (int number = 1; number <= static_cast<int>(m_context.selection.robots().size()); ++number) {
        const RobotDescription& robot = m_context.selection.robots()[static_cast<std::size_t>(number - 1)];
        const QString title = othersText(robot.title);
        // The key belongs to the robot bar.
        QAction& one = commands.add({.id = QStringLiteral("robot.%1").arg(number),
                                     .menu = CommandMenu::Robot,
                                     .text = tr("Select %1\t%2").arg(title).arg(number),
                                     .hint = tr("Select %1").arg(title)});
        connect(&one, &QAction::triggered, this,
                [this, number] { m_context.selection.selectNumber(number); });
    }
}

void RobotsFeature::addCommands(Station& station) {
    CommandTable& commands = m_context.commands;
    commands.separate(CommandMenu::Robot);
    QAction& stop = commands.add({.id = "robot.stop",
                                  .menu = CommandMenu::Robot,
                                  .text = tr("&Stop all robots\tEsc"),
                                  .hint = tr("All robots stand until each is released")});
    connect(&stop, &QAction::triggered, this, [&station] { station.stopAll(); });
    QMenu* modes = commands.menu(CommandMenu::Robot).addMenu(tr("&Mode"));
    connect(modes, &QMenu::aboutToShow, this, [this, modes] { fillModes(*modes); });
    new ServiceMenu(m_context, station);
}

void RobotsFeature::fillModes(QMenu& modes) {
    modes.clear();
    const std::string robot = m_context.selection.name().toStdString();
    const RobotState& reported = m_context.source.moment().reported(robot);
    if (!reported.mode) {
        modes.addAction(tr("The robot has reported none yet"))->setEnabled(false);
        return;
    }
    const ModeSample& now = reported.mode->sample;
    for (const std::string& mode : now.available) {
        QAction* one = modes.addAction(modeName(mode));
        one->setCheckable(true);
        one->setChecked(mode == now.mode);
        connect(one, &QAction::triggered, this, [this, robot, mode] {
            m_context.liveStation->requestGrant(robot);
            if (const auto asked = m_context.liveStation->setMode(robot, mode); !asked)
                m_context.notify(QString::fromStdString(asked.error().text));
        });
    }
}

void RobotsFeature::show(const LiveMoment& moment) {
    std::vector<RobotChip> chips;
    std::vector<StopLine> stops;
    for (const RobotDescription& robot : m_context.selection.robots()) {
        const RobotFace face = m_context.selection.faceOfRobot(robot);
        const RobotView& view = moment.view(robot.name);
        chips.push_back(robotChipOf(face, view, moment.reported(robot.name), moment.now));
        if (m_stop != nullptr) stops.push_back(stopLineOf(face, view));
    }
    m_bar->show(chips, stops, m_context.selection.name());
}

}  // namespace leitstand
