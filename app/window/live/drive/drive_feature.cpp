#include "app/window/live/drive/drive_feature.h"

#include <QAction>
#include <QMainWindow>

#include "app/services/station/safety/station_alarms.h"
#include "app/window/commands/command_table.h"
#include "app/window/live/frame/pane_docks.h"
#include "app/window/live/input/selection.h"
#include "app/window/live/live_bridge.h"
#include "widgets/drive/drive_strip.h"
#include "widgets/models/live/robots/drive_state.h"

namespace leitstand {

DriveFeature::DriveFeature(const LiveContext& context)
    : QObject(&context.window),
      m_context(context),
      m_input(context.window),
      m_strip(new DriveStrip(&context.window)) {
    context.panes.add(QStringLiteral("strip"), tr("Robot"), *m_strip);
    context.panes.keepInSight(QStringLiteral("strip"));
    Station& station = context.bridge.station();
    connect(&m_input, &DriveInput::sticks, this,
            [this, &station](const DriveVelocity& sticks) { station.push(sticks, m_input.withoutEyes()); });
    connect(&m_input, &DriveInput::halted, this, [&station] { station.halt(); });
    connect(&m_input, &DriveInput::focusChanged, this, [this, &station](bool focus) {
        const std::string robot = m_context.selection.name().toStdString();
        if (focus) station.ask(robot);
        station.focus(focus ? robot : std::string());
        m_drive->setChecked(m_input.keysHaveFocus());
    });
    const auto setRobot = [this] {
        if (const RobotDescription* robot = m_context.selection.robot()) m_input.setRobot(*robot);
    };
    addCommands();
    connect(&context.selection, &Selection::changed, this, setRobot);
    setRobot();
    connectStrip();
    connect(&context.bridge, &LiveBridge::ticked, this, &DriveFeature::show);
}

void DriveFeature::addCommands() {
    m_drive =
        &m_context.commands.add({.id = "robot.drive",
                                 .menu = CommandMenu::Robot,
                                 .text = tr("&Drive with keys"),
                                 .hint = tr("W S A D or the arrows drive the selected robot; Shift slow, "
                                            "Ctrl fast, Space halts, G held drives without eyes"),
                                 .keys = QKeySequence(Qt::Key_F2),
                                 .checkable = true});
    connect(m_drive, &QAction::triggered, this, &DriveFeature::setDriving);
    connect(&m_input, &DriveInput::pressedInVain, this, [this] {
        const QString keys = m_drive->shortcut().toString(QKeySequence::NativeText);
        emit m_context.source.told(tr("The keys do not drive: %1 lets them").arg(keys));
    });
}

void DriveFeature::connectStrip() {
    Station& station = m_context.bridge.station();
    const auto selected = [this] { return m_context.selection.name().toStdString(); };
    connect(m_strip, &DriveStrip::grantAsked, this, [&station, selected] { station.ask(selected()); });
    connect(m_strip, &DriveStrip::grantGivenUp, this, [this, &station, selected] {
        setDriving(false);
        station.giveUp(selected());
    });
    connect(m_strip, &DriveStrip::grantAnswered, this,
            [&station, selected](bool consent) { station.answer(selected(), consent); });
}

void DriveFeature::setDriving(bool on) {
    if (on) m_context.bridge.station().ask(m_context.selection.name().toStdString());
    m_input.setFocus(on);
}

void DriveFeature::show(const LiveMoment& moment) {
    const RobotDescription* const robot = m_context.selection.robot();
    if (robot == nullptr) return;
    m_strip->show(driveStateOf(m_context.selection.face(), *robot, moment.view(robot->name),
                               moment.said(robot->name), m_context.bridge.gas(robot->name), moment.now,
                               m_context.bridge.station().alarms().limits()));
}

}  // namespace leitstand
