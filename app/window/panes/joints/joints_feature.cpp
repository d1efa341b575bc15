#include "app/window/panes/joints/joints_feature.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include <QAction>
#include <QKeyEvent>
#include <QMainWindow>

#include "app/services/station/joints/joint_moving.h"
#include "app/services/station/station.h"
#include "app/window/commands/command_table.h"
#include "app/window/input/selection.h"
#include "app/window/source/moment_source.h"
#include "core/event/motion_samples.h"
#include "widgets/joints/joints_panel.h"
#include "widgets/models/others_text.h"

namespace leitstand {
namespace {

constexpr std::chrono::milliseconds RenewEvery(50);  // the station forgets a motion after 200 ms
constexpr int PresetKeys = 6;

enum Way { Up, Down, Halt };

}  // namespace

JointsFeature::JointsFeature(const ViewContext& context)
    : QObject(&context.window), m_context(context), m_panel(new JointsPanel(&context.window)) {
    m_panel->setObjectName(QStringLiteral("jointsPane"));
    if (context.liveStation != nullptr) addCommands();
    connect(m_panel, &JointsPanel::axisChosen, this, &JointsFeature::choose);
    connect(&context.selection, &Selection::changed, this, &JointsFeature::changeRobot);
    connect(&context.source, &MomentSource::ticked, this, &JointsFeature::show);
    m_renewal.setInterval(RenewEvery);
    connect(&m_renewal, &QTimer::timeout, this, &JointsFeature::renew);
    changeRobot();
}

QWidget& JointsFeature::pane() const {
    return *m_panel;
}

void JointsFeature::addCommands() {
    m_keys.emplace(
        m_context.window,
        [this](const QKeyEvent& event) -> std::optional<int> {
            if (!chosen() || event.modifiers().testFlag(Qt::ShiftModifier)) return std::nullopt;
            if (event.key() == Qt::Key_J) return Up;
            if (event.key() == Qt::Key_K) return Down;
            // Who drives has Space anyway, which then also releases the keys.
            const bool drives = m_context.source.moment().view(m_robot.toStdString()).drive.focus;
            if (event.key() == Qt::Key_Space && !drives && isMoving()) return Halt;
            return std::nullopt;
        },
        [this] { return m_context.source.moment().view(m_robot.toStdString()).drive.focus; });
    connect(&*m_keys, &HeldKeys::pressed, this, [this](int way) {
        if (way == Halt) return m_context.liveStation->halt();
        if (!mayMove())
            m_context.notify(tr("Joints move only with drive control of a robot that is not stopped"));
    });
    connect(&*m_keys, &HeldKeys::changed, this, [this] { move(m_keys->share(Up, Down)); });
    m_context.commands.separate(CommandMenu::Robot);
    m_next = &m_context.commands.add({.id = QStringLiteral("joints.next"),
                                      .menu = CommandMenu::Robot,
                                      .text = tr("&Next flippers or joint"),
                                      .hint = tr("J raises what is chosen while it is held, K lowers it"),
                                      .keys = QKeySequence(Qt::SHIFT | Qt::Key_J)});
    connect(m_next, &QAction::triggered, this, &JointsFeature::chooseNext);
    m_pad = &m_context.commands.add({.id = QStringLiteral("joints.pad"),
                                     .menu = CommandMenu::Robot,
                                     .text = tr("Gamepad moves &joints"),
                                     .hint = tr("With the trigger held, the stick that turns cameras raises "
                                                "and lowers what is chosen instead"),
                                     .keys = QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_J),
                                     .checkable = true});
    connect(m_pad, &QAction::toggled, this, [this] {
        m_stickFree = m_stick == 0.0;
        move(0.0);
    });
    addPresets();
}

void JointsFeature::addPresets() {
    std::vector<QAction*> buttons = {m_next};
    for (int i = 0; i < PresetKeys; ++i) {
        QAction& preset = m_context.commands.add(
            {.id = QStringLiteral("joints.preset%1").arg(i + 1),
             .menu = CommandMenu::Robot,
             .text = tr("Joints to preset %1").arg(i + 1),
             .hint = tr("Moves all joints of the chosen group to a pose of the robot's "
                        "file; Space or STOP ends it"),
             .keys = QKeySequence(Qt::CTRL | Qt::ALT | (Qt::Key_1 + i))});
        connect(&preset, &QAction::triggered, this, [this, i] { goTo(static_cast<std::size_t>(i)); });
        m_presets.push_back(&preset);
        buttons.push_back(&preset);
    }
    m_panel->setCommands(buttons);
}

std::optional<JointAxisId> JointsFeature::chosen() const {
    const auto found = m_chosen.find(m_robot);
    return found == m_chosen.end() ? std::nullopt : std::optional(found->second);
}

const JointGroup* JointsFeature::group() const {
    const RobotDescription* const robot = m_context.selection.robot();
    const auto axis = chosen();
    if (robot == nullptr || !axis) return nullptr;
    const auto found = std::find_if(robot->jointGroups.begin(), robot->jointGroups.end(),
                                    [&](const JointGroup& one) { return one.name == axis->group; });
    return found == robot->jointGroups.end() ? nullptr : &*found;
}

bool JointsFeature::padMoves() const {
    return m_pad != nullptr && m_pad->isChecked() && chosen().has_value();
}

bool JointsFeature::takesStick() const {
    return padMoves() && m_stick != 0.0;
}

void JointsFeature::takeStick(double share) {
    m_stick = share;
    if (share == 0.0) m_stickFree = true;
    if (padMoves() && m_stickFree) move(share);
}

bool JointsFeature::isMoving() const {
    const auto axis = chosen();
    if (!axis || m_context.liveStation == nullptr) return false;
    return m_context.liveStation->joints().isMoving(m_robot.toStdString());
}

bool JointsFeature::mayMove() const {
    const auto axis = chosen();
    if (!axis || m_context.liveStation == nullptr) return false;
    const auto view = m_context.liveStation->joints().view(m_robot.toStdString(), axis->group);
    return view && view->mayMove;
}

void JointsFeature::move(double share) {
    const auto axis = chosen();
    if (!axis || m_context.liveStation == nullptr) return;
    JointMoving& joints = m_context.liveStation->joints();
    const std::string robot = m_robot.toStdString();
    // The control was at rest until now; what holds it through a stop never comes here again.
    if (m_share == 0.0 && share != 0.0) joints.move(robot, axis->group, axis->axis, 0.0);
    m_share = share;
    joints.move(robot, axis->group, axis->axis, share);
    if (share == 0.0) return m_renewal.stop();
    if (!m_renewal.isActive()) m_renewal.start();
}

void JointsFeature::renew() {
    const auto axis = chosen();
    if (axis && m_context.liveStation != nullptr)
        m_context.liveStation->joints().move(m_robot.toStdString(), axis->group, axis->axis, m_share);
}

void JointsFeature::choose(const JointAxisId& axis) {
    if (chosen() == axis) return;
    move(0.0);
    m_stickFree = m_stick == 0.0;
    m_chosen[m_robot] = axis;
    nameCommands();
    show(m_context.source.moment());
}

void JointsFeature::chooseNext() {
    const RobotDescription* const robot = m_context.selection.robot();
    const auto now = chosen();
    if (robot == nullptr || !now) return;
    const std::vector<JointAxisId> axes = jointAxes(*robot);
    const auto at = std::find(axes.begin(), axes.end(), *now);
    choose(at == axes.end() || at + 1 == axes.end() ? axes.front() : *(at + 1));
}

void JointsFeature::goTo(std::size_t preset) {
    const JointGroup* const its = group();
    if (its == nullptr || m_context.liveStation == nullptr || preset >= its->presets.size()) return;
    if (!mayMove())
        return m_context.notify(tr("Joints move only with drive control of a robot that is not stopped"));
    m_context.liveStation->joints().goTo(m_robot.toStdString(), its->name, preset);
}

void JointsFeature::changeRobot() {
    move(0.0);  // of the robot until now
    m_stickFree = m_stick == 0.0;
    if (m_keys) m_keys->letGo();
    m_robot = m_context.selection.name();
    const RobotDescription* const robot = m_context.selection.robot();
    if (robot != nullptr && !m_chosen.contains(m_robot)) {
        const std::vector<JointAxisId> axes = jointAxes(*robot);
        if (!axes.empty()) m_chosen[m_robot] = axes.front();
    }
    nameCommands();
    show(m_context.source.moment());
}

void JointsFeature::nameCommands() {
    if (m_next == nullptr) return;
    const JointGroup* const its = group();
    m_next->setEnabled(its != nullptr);
    m_next->setIconText(tr("Next"));
    m_pad->setEnabled(its != nullptr);
    for (std::size_t i = 0; i < m_presets.size(); ++i) {
        QAction& preset = *m_presets[i];
        const bool known = its != nullptr && i < its->presets.size();
        preset.setEnabled(known);
        preset.setVisible(known);
        if (!known) continue;
        const QString title = othersText(its->presets[i].title);
        preset.setText(tr("%1: %2", "flippers: a preset").arg(othersText(its->title), title));
        preset.setIconText(title);
    }
}

JointGroupViews JointsFeature::views(const LiveMoment& moment) const {
    JointGroupViews all;
    const RobotDescription* const robot = m_context.selection.robot();
    if (robot == nullptr) return all;
    const RobotView& view = moment.view(robot->name);
    for (const JointGroup& one : robot->jointGroups) {
        if (m_context.liveStation != nullptr) {
            if (auto now = m_context.liveStation->joints().view(robot->name, one.name)) all[one.name] = *now;
            continue;
        }
        JointGroupView& recorded = all[one.name];
        recorded.mayMove = true;  // nobody moves them, so nothing is missing
        for (const MovedJoint& joint : one.joints) {
            std::optional<double> position;
            if (view.joints) {
                const auto& names = view.joints->names;
                const auto at = static_cast<std::size_t>(std::find(names.begin(), names.end(), joint.name) -
                                                         names.begin());
                if (at < view.joints->positions.size()) position = view.joints->positions[at];
            }
            recorded.positions.push_back(position);
        }
    }
    return all;
}

void JointsFeature::show(const LiveMoment& moment) {
    // Moments come 30 times a second; what stands still is not laid out and painted again.
    Shown now{m_context.selection.robot(), views(moment), chosen().value_or(JointAxisId{})};
    if (m_shown == now) return;
    m_panel->show(now.robot, now.groups, now.chosen);
    m_shown = std::move(now);
}

}  // namespace leitstand
