#include "app/window/panes/finds/victims_feature.h"

#include <algorithm>
#include <utility>

#include <QAction>
#include <QApplication>
#include <QMainWindow>

#include "app/services/finds/find_desk.h"
#include "app/services/station/station.h"
#include "app/services/station/station_mapping.h"
#include "app/window/commands/command_table.h"
#include "app/window/frame/pane_docks.h"
#include "app/window/input/selection.h"
#include "app/window/panes/camera/camera_feature.h"
#include "app/window/panes/finds/form_pictures.h"
#include "app/window/panes/map/map_feature.h"
#include "app/window/panes/map/map_gestures.h"
#include "app/window/panes/map/robots_on_map.h"
#include "app/window/source/moment_source.h"
#include "core/mission/finds/find_book.h"
#include "widgets/map_view/map_view.h"
#include "widgets/models/map/robots/robot_mark.h"
#include "widgets/models/numbers.h"
#include "widgets/models/victims/merge_text.h"
#include "widgets/models/victims/move_text.h"
#include "widgets/models/victims/tag_choices.h"
#include "widgets/victims/victim_form.h"
#include "widgets/victims/victims_panel.h"

namespace leitstand {
namespace {

using Kind = FindSample::Kind;
constexpr int TicksARow = 6;  ///< ticks between updates of the rows: 5 Hz

}  // namespace

VictimsFeature::VictimsFeature(const LiveContext& context, MapFeature& map, CameraFeature& cameras)
    : QObject(&context.window),
      m_context(context),
      m_map(map),
      m_cameras(cameras),
      m_panel(new VictimsPanel(&context.window)),
      m_form(new VictimForm(&context.window)),
      m_pictures(new FormPictures(*m_form, context.station.folder())) {
    m_panel->setObjectName(QStringLiteral("victimsPane"));
    m_form->setObjectName(QStringLiteral("formPane"));
    addFreezing();
    addDecisions();
    addPlacing();
    addForm();
    m_panel->addCommands({m_actions.at(QStringLiteral("victim.freeze")),
                          m_actions.at(QStringLiteral("victim.confirm")),
                          m_actions.at(QStringLiteral("victim.discard"))});
    connect(m_panel, &VictimsPanel::chosenChanged, this, &VictimsFeature::showForm);
    connect(m_panel, &VictimsPanel::activated, this, [this] { fillIn(1); });
    connect(m_form, &VictimForm::edited, this, [this](const FindSample& find) { answer(desk().edit(find)); });
    connect(m_form, &VictimForm::done, this, [this] {
        m_context.panes.putAway(QStringLiteral("form"));
        m_context.panes.setFocus();  // keys drive the robot again
    });
    connect(&context.source, &MomentSource::ticked, this, &VictimsFeature::show);
}

QWidget& VictimsFeature::list() const {
    return *m_panel;
}

QWidget& VictimsFeature::form() const {
    return *m_form;
}

FindDesk& VictimsFeature::desk() const {
    return m_context.station.finds();
}

QAction& VictimsFeature::add(const char* id, const QString& text, const QString& brief, const QString& hint,
                             const QKeySequence& keys) {
    const QString name = QString::fromLatin1(id);
    QAction& action = m_context.commands.add(
        {.id = name, .menu = CommandMenu::Mission, .text = text, .hint = hint, .keys = keys});
    action.setIconText(brief);
    action.setAutoRepeat(false);  // a held key triggers once
    m_actions.emplace(name, &action);
    return action;
}

void VictimsFeature::addFreezing() {
    m_context.commands.separate(CommandMenu::Mission);
    const auto filing = [this](const char* id, const QString& text, const QString& brief, const QString& hint,
                               const QKeySequence& keys, Kind kind) {
        connect(&add(id, text, brief, hint, keys), &QAction::triggered, this, [this, kind] { freeze(kind); });
    };
    filing("victim.freeze", tr("&Victim here"), tr("F Victim"),
           tr("Keeps what the robot sees as a victim: the sharpest pictures, heat, gas, scan and place"),
           Qt::Key_F, Kind::Victim);
    connect(&add("victim.confirm", tr("Con&firm the find"), tr("V Confirm"),
                 tr("Confirms the chosen find, or the one that was filed last; files a chosen candidate"),
                 Qt::Key_V),
            &QAction::triggered, this, &VictimsFeature::confirm);
    filing("victim.hazard", tr("Ha&zard here"), tr("Hazard"), tr("The same for a hazard sign"),
           QKeySequence(Qt::SHIFT | Qt::Key_H), Kind::Hazard);
    filing("victim.code", tr("&QR code here"), tr("Code"), tr("The same for a QR code"),
           QKeySequence(Qt::SHIFT | Qt::Key_C), Kind::Code);
    filing("victim.object", tr("&Object here"), tr("Object"), tr("The same for an object of interest"),
           QKeySequence(Qt::SHIFT | Qt::Key_B), Kind::Object);
}

void VictimsFeature::addDecisions() {
    connect(&add("victim.discard", tr("&Discard the find"), tr("Discard"),
                 tr("Takes the chosen find or candidate, or the newest find, off the list; undo brings it "
                    "back"),
                 QKeySequence(Qt::SHIFT | Qt::Key_Delete)),
            &QAction::triggered, this, [this] {
                const auto chosen = m_panel->chosen();
                if (chosen && !chosen->filed()) return answer(desk().dismiss(chosen->candidate));
                if (const auto find = meant()) return answer(desk().discard(*find));
                m_context.notify(tr("Choose the find that is none"));
            });
    connect(
        &add("victim.merge", tr("&Merge with the nearest"), tr("Merge"),
             tr("The chosen find is the same as the nearest one of its kind, which gets its evidence"), {}),
        &QAction::triggered, this, &VictimsFeature::merge);
    connect(&add("victim.undo", tr("Undo the last &entry on finds"), tr("Undo"),
                 tr("Takes back what was filed, changed, confirmed or discarded last"),
                 QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_U)),
            &QAction::triggered, this, [this] { answer(desk().undo()); });
}

void VictimsFeature::addPlacing() {
    QAction& action = m_context.commands.add(
        {.id = QStringLiteral("victim.move"),
         .menu = CommandMenu::Mission,
         .text = tr("Mo&ve the find on the map"),
         .hint = tr("Click on the map where the chosen find is; without one a new victim is filed there"),
         .keys = QKeySequence(Qt::SHIFT | Qt::Key_V),
         .checkable = true});
    m_actions.emplace(QStringLiteral("victim.move"), &action);
    connect(&action, &QAction::triggered, this, &VictimsFeature::move);
}

void VictimsFeature::addForm() {
    // For gamepads, whose buttons layouts bind to commands.
    connect(&add("form.next", tr("Form: &next field"), tr("Next"), tr("Of the chosen find's form"), {}),
            &QAction::triggered, this, [this] { fillIn(1); });
    connect(&add("form.previous", tr("Form: &previous field"), tr("Previous"),
                 tr("Of the chosen find's form"), {}),
            &QAction::triggered, this, [this] { fillIn(-1); });
    connect(&add("form.change", tr("Form: next &choice"), tr("Change"),
                 tr("Unknown, absent, present; situations; areas"), {}),
            &QAction::triggered, this, &VictimsFeature::changeField);
}

void VictimsFeature::fillIn(int step) {
    const auto chosen = m_panel->chosen();
    if (!chosen || !chosen->filed()) return m_context.notify(tr("Choose a filed find, to fill in its form"));
    m_context.panes.open(QStringLiteral("form"));
    showForm();
    m_form->nextField(step);
}

void VictimsFeature::changeField() {
    if (!isFillingIn()) return fillIn(1);
    if (!m_form->change(1)) m_context.notify(tr("Nothing to choose from here: what was typed stays"));
}

bool VictimsFeature::isFillingIn() const {
    return QApplication::focusWidget() != nullptr && m_form->isAncestorOf(QApplication::focusWidget());
}

void VictimsFeature::freeze(Kind kind) {
    desk().freeze(m_context.selection.name().toStdString(), kind,
                  m_cameras.views().sensor(CameraPlace::Large));
}

std::optional<FindKey> VictimsFeature::meant() const {
    const auto chosen = m_panel->chosen();
    if (chosen) return chosen->filed() ? std::optional(chosen->find) : std::nullopt;
    // Without a choice only what was just filed can be meant.
    return desk().unconfirmed();
}

void VictimsFeature::confirm() {
    const auto chosen = m_panel->chosen();
    // The second press means what was filed after something was chosen, or is being filed. That includes a
    // candidate that is still shown as one until the list is updated.
    const bool newer = desk().isFiling() || (desk().filings() != m_shown && desk().unconfirmed());
    if (chosen && !chosen->filed() && !(newer && chosen->candidate == m_asked)) {
        m_asked = chosen->candidate;
        return answer(desk().fileCandidate(chosen->candidate));
    }
    answer(chosen && !newer ? desk().confirm(chosen->find) : desk().confirmNewest());
}

void VictimsFeature::merge() {
    const auto find = meant();
    if (!find) return m_context.notify(tr("Choose the find that is part of another one"));
    const MergeOffer offer = mergeOffer(*m_context.source.moment().mission, *find);
    if (offer.into) {
        if (const auto merged = desk().merge(*find, *offer.into); !merged) return answer(merged);
    }
    m_context.notify(offer.text);
}

void VictimsFeature::move(bool on) {
    if (!on) return m_map.gestures().disarm();
    const auto chosen = m_panel->chosen();
    const std::string robot = m_context.selection.name().toStdString();
    const bool filed = chosen && chosen->filed();
    m_map.gestures().armPose(
        *m_actions.at(QStringLiteral("victim.move")), m_map.robots().placeMark(robot),
        filed ? tr("Click where %1 is · right button: not at all").arg(chosen->name)
              : tr("Click where the victim is · right button: not at all"),
        [this, robot, filed, find = filed ? chosen->find : FindKey()](const GroundPose& pose) {
            if (filed) return answer(desk().move(find, pose.place));
            desk().freezeAt(robot, Kind::Victim, aboveFloor(pose.place));
        });
}

void VictimsFeature::answer(const Result<void>& done) {
    if (!done) m_context.notify(QString::fromStdString(done.error().text));
}

void VictimsFeature::show(const LiveMoment& moment) {
    if (m_sinceRows++ % TicksARow != 0) return;
    const std::string robot = m_context.selection.name().toStdString();
    std::optional<Pose> baseInMap;
    const RobotsInMapPtr robots = m_context.station.mapping().robots();
    for (const RobotInMap& one : *robots) {
        if (one.robot == robot && one.placed) baseInMap = one.baseInMap;
    }
    const bool following = std::exchange(m_following, true);
    const auto moved = m_moves.follow(*moment.mission);
    // The first moves are of earlier sessions.
    if (following && !moved.empty()) m_context.notify(movesText(moved));
    const auto rows = victimRows(*moment.mission, baseInMap, &m_moves);
    m_panel->show(rows);
    // The next key is about what was filed last, once the mission has it. An operator who fills in a form is
    // not disturbed.
    const auto newest = desk().newest();
    const auto filings = desk().filings();
    if (newest && filings != m_shown && !isFillingIn() && m_panel->choose(*newest)) m_shown = filings;
    const auto chosen = m_panel->chosen();
    m_map.view().setFinds(rows, chosen && chosen->filed() ? std::optional(chosen->find) : std::nullopt);
    showForm();
}

void VictimsFeature::showForm() {
    const auto chosen = m_panel->chosen();
    const auto& finds = *m_context.source.moment().mission->finds;
    const auto entry = chosen && chosen->filed() ? finds.find(chosen->find) : finds.end();
    if (entry != finds.end())
        m_form->setTags(tagChoices(*m_context.source.moment().mission, entry->second.victim));
    const auto find = entry == finds.end() ? std::nullopt : std::optional(entry->second.victim);
    m_form->show(find);
    if (m_form->isVisible()) m_pictures->follow(find);
}

}  // namespace leitstand
