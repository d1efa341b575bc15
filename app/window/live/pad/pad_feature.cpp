#include "app/window/live/pad/pad_feature.h"

#include <algorithm>
#include <utility>

#include <QAction>
#include <QApplication>
#include <QMainWindow>
#include <QWindow>

#include "app/window/commands/command_table.h"
#include "app/window/input/drive_input.h"
#include "app/window/input/selection.h"
#include "app/window/input/worked_in.h"
#include "app/window/source/moment_source.h"
#include "widgets/pad/pad_legend.h"
#include "widgets/pad/pad_mapping_dialog.h"

namespace leitstand {
namespace {

/// Returns whether anybody's stop keeps @p robot from moving.
bool isStopped(const RobotView& robot) {
    return robot.stop.sent || robot.stop.stopped || robot.stop.releasing;
}

}  // namespace

PadFeature::PadFeature(const LiveContext& context, DriveInput& drive, PadMemory memory)
    : QObject(&context.window),
      m_context(context),
      m_input({.memory = std::move(memory), .onStop = [&station = context.station] { station.stopAll(); }},
              this),
      m_legend(new PadLegend(&context.window)) {
    m_legend->hide();
    connect(m_legend, &PadLegend::clicked, this, [this] { showLegend(false); });
    addCommands();
    connectDrive(drive);
    connectTexts();
    context.window.installEventFilter(this);
    connect(qApp, &QGuiApplication::focusWindowChanged, this, &PadFeature::allow);
    connect(&context.source, &MomentSource::ticked, this, &PadFeature::allow);
    connect(&context.selection, &Selection::changed, this, &PadFeature::useRobot);
    connect(&m_input, &PadInput::commandWanted, &context.commands, &CommandTable::trigger);
    connect(&m_input, &PadInput::padsChanged, this, [this] {
        refresh();
        fillDialog();
    });
    connect(&m_input, &PadInput::moved, this, &PadFeature::refresh);
    useRobot();
}

PadFeature::~PadFeature() = default;

void PadFeature::addCommands() {
    CommandTable& commands = m_context.commands;
    QAction& next = commands.add({.id = "robot.next",
                                  .menu = CommandMenu::Robot,
                                  .text = tr("Select the &next robot"),
                                  .hint = tr("Selects the next robot, after the last one the first")});
    connect(&next, &QAction::triggered, this, &PadFeature::selectNext);
    QAction& bind = commands.add({.id = "pad.controls",
                                  .menu = CommandMenu::Robot,
                                  .text = tr("&Gamepad …"),
                                  .hint = tr("Which gamepad drives, and what its controls do")});
    connect(&bind, &QAction::triggered, this, &PadFeature::openDialog);
    m_legendAction = &commands.add({.id = "pad.legend",
                                    .menu = CommandMenu::Help,
                                    .text = tr("&Controls of the gamepad"),
                                    .hint = tr("Shows what each control of the gamepad does"),
                                    .keys = QKeySequence(Qt::Key_H),
                                    .checkable = true});
    connect(m_legendAction, &QAction::toggled, this, &PadFeature::showLegend);
}

void PadFeature::connectDrive(DriveInput& drive) {
    connect(&m_input, &PadInput::sticks, &drive, &DriveInput::setPad);
    connect(&drive, &DriveInput::padMustLetGo, &m_input, &PadInput::needNeutral);
}

void PadFeature::connectTexts() {
    connect(&m_input, &PadInput::notified, this, [this](const QString& text) { m_context.notify(text); });
    connect(&m_input, &PadInput::connected, this, [this](const QString& name) {
        m_context.notify(tr("%1 is plugged in; H shows its controls.").arg(name));
    });
    connect(&m_input, &PadInput::gone, this,
            [this](const QString& name) { m_context.notify(tr("%1 is unplugged.").arg(name)); });
    connect(&m_input, &PadInput::needsNeutral, this, [this](bool needs) {
        if (needs)
            m_context.notify(tr("Let the sticks go first, and the trigger too if that is not enough."));
    });
}

void PadFeature::useRobot() {
    const RobotDescription* const robot = m_context.selection.robot();
    m_input.setLimits(robot == nullptr ? DriveLimits{} : limitsOf(*robot));
    m_input.needNeutral();
    allow();
}

void PadFeature::allow() {
    const RobotView& robot = m_context.source.moment().view(m_context.selection.name().toStdString());
    m_input.setScope(!isWorkedIn(m_context.window) ? PadScope::Nothing
                     : isStopped(robot)            ? PadScope::Commands
                                                   : PadScope::All);
}

bool PadFeature::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::WindowDeactivate) allow();
    if (event->type() == QEvent::Resize && m_legend->isVisible()) showLegend(true);
    return QObject::eventFilter(watched, event);
}

void PadFeature::selectNext() {
    const auto& robots = m_context.selection.robots();
    const auto now = std::find_if(robots.begin(), robots.end(), [this](const RobotDescription& one) {
        return &one == m_context.selection.robot();
    });
    if (now == robots.end()) return;
    const auto number = static_cast<std::size_t>(now - robots.begin()) + 1;  // from 1
    m_context.selection.selectNumber(static_cast<int>(number % robots.size()) + 1);
}

std::vector<PadCommandFace> PadFeature::faces() const {
    std::vector<PadCommandFace> faces;
    for (const QAction* action : m_context.commands.all()) {
        // Text behind a tab is a key.
        const QString text = action->text().section(QLatin1Char('\t'), 0, 0).remove(QLatin1Char('&'));
        faces.push_back({action->objectName().toStdString(), text, action->toolTip()});
    }
    return faces;
}

void PadFeature::useLayout(const std::map<std::string, std::string>& byButton) {
    m_input.setLayoutCommands(byButton);
}

void PadFeature::showLegend(bool on) {
    m_legendAction->setChecked(on);
    m_legend->setVisible(on);
    if (!on) return;
    const QSize room = m_context.window.size();
    const QSize size = m_legend->sizeHint().boundedTo(room - QSize(32, 32));
    m_legend->setGeometry(
        QRect(QPoint((room.width() - size.width()) / 2, (room.height() - size.height()) / 2), size));
    m_legend->setCommands(faces());
    refresh();
    m_legend->raise();
}

void PadFeature::openDialog() {
    if (m_dialog == nullptr) {
        m_dialog = new PadMappingDialog(&m_context.window);
        connect(m_dialog, &PadMappingDialog::padChosen, &m_input, &PadInput::choose);
        connect(m_dialog, &PadMappingDialog::saved, &m_input, &PadInput::setBindings);
    }
    m_dialog->setCommands(faces());
    fillDialog();
    m_dialog->show();
    m_dialog->raise();
    m_dialog->activateWindow();
}

void PadFeature::fillDialog() {
    if (m_dialog == nullptr) return;
    std::vector<PadChoice> choices;
    for (const PadInfo& pad : m_input.pads()) choices.push_back({pad.id, QString::fromStdString(pad.name)});
    m_dialog->setPads(choices, m_input.chosen().id);
    m_dialog->setBindings(m_input.ownBindings());
    m_dialog->setState(m_input.state());
}

void PadFeature::refresh() {
    if (m_legend->isVisible()) {
        const QString pad = QString::fromStdString(m_input.chosen().name);
        // Without a pad: the default controls of a known one.
        m_legend->setPad(pad, pad.isEmpty() ? defaultBindings(PadLayout::Standard) : m_input.bindings());
        m_legend->setState(m_input.state());
    }
    if (m_dialog != nullptr && m_dialog->isVisible()) m_dialog->setState(m_input.state());
}

}  // namespace leitstand
