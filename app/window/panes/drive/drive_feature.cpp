#include "app/window/panes/drive/drive_feature.h"

#include <QAction>
#include <QMainWindow>

#include "app/services/station/station.h"
#include "app/window/commands/command_table.h"
#include "app/window/input/selection.h"
#include "app/window/source/moment_source.h"
#include "widgets/drive/drive_strip.h"

namespace leitstand {

DriveFeature::DriveFeature(const LiveContext& context, DriveStrip& strip)
    : QObject(&context.window), m_context(context), m_input(context.window) {
    Station& station = context.station;
    connect(&m_input, &DriveInput::sticks, this, [this, &station](const DriveVelocity& sticks) {
        station.setStick(sticks, m_input.withoutEyes());
    });
    connect(&m_input, &DriveInput::halted, this, [&station] { station.halt(); });
    connect(&m_input, &DriveInput::focusChanged, this, [this, &station](bool focus) {
        const std::string robot = m_context.selection.name().toStdString();
        if (focus) station.requestGrant(robot);
        station.setDriveFocus(focus ? robot : std::string());
        m_drive->setChecked(m_input.keysHaveFocus());
    });
    const auto setRobot = [this] {
        if (const RobotDescription* robot = m_context.selection.robot()) m_input.setRobot(*robot);
    };
    addCommands();
    connect(&context.selection, &Selection::changed, this, setRobot);
    setRobot();
    connectStrip(strip);
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
        m_context.notify(tr("The keys do not drive: %1 lets them").arg(keys));
    });
}

void DriveFeature::connectStrip(DriveStrip& strip) {
    Station& station = m_context.station;
    const auto selected = [this] { return m_context.selection.name().toStdString(); };
    connect(&strip, &DriveStrip::grantAsked, this,
            [&station, selected] { station.requestGrant(selected()); });
    connect(&strip, &DriveStrip::grantGivenUp, this, [this, &station, selected] {
        setDriving(false);
        station.releaseGrant(selected());
    });
    connect(&strip, &DriveStrip::grantAnswered, this,
            [&station, selected](bool consent) { station.answerRequest(selected(), consent); });
}

void DriveFeature::setDriving(bool on) {
    if (on) m_context.station.requestGrant(m_context.selection.name().toStdString());
    m_input.setFocus(on);
}

}  // namespace leitstand
