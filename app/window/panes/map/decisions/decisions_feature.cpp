#include "app/window/panes/map/decisions/decisions_feature.h"

#include <utility>

#include <QAction>
#include <QKeySequence>
#include <QMainWindow>

#include "app/services/station/station_mapping.h"
#include "app/window/commands/command_table.h"
#include "app/window/input/selection.h"
#include "app/window/panes/map/map_gestures.h"
#include "app/window/panes/map/robots_on_map.h"
#include "app/window/source/live_moment.h"
#include "app/window/source/moment_source.h"
#include "core/base/rotation/heading.h"
#include "core/mission/state/decision.h"
#include "widgets/map_decisions/decisions_panel.h"
#include "widgets/map_view/map_view.h"
#include "widgets/models/map/decision_text.h"
#include "widgets/models/numbers.h"

namespace leitstand {
namespace {

/// Returns the pose of @p scan in the map when its robot stands at @p pose on the ground. Height and tilt
/// stay.
Pose drawnPose(const LiveKeyScan& scan, const GroundPose& pose) {
    const Pose was = scan.pose.scanInMap * scan.sensorInBase.inverse();
    Eigen::Vector3d place = pose.place;
    place.z() = was.translation().z();
    const double turn = pose.heading.value_or(headingOf(was)) - headingOf(was);
    Pose base = was;  // keeps its tilt
    base.linear() = Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()) * was.linear();
    base.translation() = place;
    return base * scan.sensorInBase;
}

}  // namespace

DecisionsFeature::DecisionsFeature(const MapContext& context, MapView& view, MapGestures& gestures,
                                   RobotsOnMap& robots, QObject* parent)
    : QObject(parent),
      m_context(context),
      m_view(view),
      m_gestures(gestures),
      m_robots(robots),
      m_panel(new DecisionsPanel(m_scans, &context.window)) {
    const std::vector<RobotFace> faces = context.selection.faces();
    m_scans.setRobots(faces);
    addDecisions();
    addArea();
    connect(m_panel, &DecisionsPanel::chosenChanged, this, &DecisionsFeature::show);
    connect(&context.source, &MomentSource::scansChanged, this, [this](const LiveMapPtr& scans) {
        m_scans.setScans(scans);
        show();
    });
    connect(&context.source, &MomentSource::ticked, this,
            [this](const LiveMoment& moment) { follow(*moment.mission); });
    m_scans.setScans(context.mapping.scans());
    show();
    showArea();
}

QWidget& DecisionsFeature::pane() const {
    return *m_panel;
}

std::uint64_t DecisionsFeature::chosen() const {
    return m_panel->chosen();
}

QAction& DecisionsFeature::add(const QString& id, const QString& text, const QString& hint,
                               const QKeySequence& keys, bool checkable) {
    return m_context.commands.add({.id = id,
                                   .menu = CommandMenu::Map,
                                   .text = text,
                                   .hint = hint,
                                   .keys = keys,
                                   .checkable = checkable});
}

void DecisionsFeature::addDecisions() {
    m_context.commands.separate(CommandMenu::Map);
    StationMapping& mapping = m_context.mapping;
    QAction& next = add("scan.nextUncertain", tr("Ne&xt doubtful scan"),
                        tr("Goes to the newest scan that waits for a decision, then to older ones"),
                        QKeySequence(Qt::Key_N));
    QAction& accept = add("scan.accept", tr("&Accept scan"), tr("The chosen scan counts where it stands"),
                          QKeySequence(Qt::Key_Insert));
    QAction& reject =
        add("scan.reject", tr("Re&ject scan"), tr("The chosen scan is set aside: neither shown nor used"),
            QKeySequence(Qt::Key_Delete));
    QAction& again = add("scan.retry", tr("Re&try scan"),
                         tr("Registers the chosen scan again, with the search chosen below"),
                         QKeySequence(Qt::CTRL | Qt::Key_R));
    QAction& drag =
        add("scan.retryFromPose", tr("Retry from a &pose"),
            tr("Click on the map where the robot was, drag its heading: the chosen scan is registered "
               "again from there"),
            QKeySequence(Qt::SHIFT | Qt::Key_R), true);
    QAction& loop = add(
        "loop.draw", tr("Show a place that it &meets"),
        tr("Click on the map where the robot was at the chosen scan by an older part of the map, drag its "
           "heading: where it fits there, the map asks whether it is the same place"),
        QKeySequence(Qt::SHIFT | Qt::Key_M), true);
    QAction& back = add("scan.rewind", tr("Re&wind to here"),
                        tr("Sets aside all scans that entered after the chosen one"),
                        QKeySequence(Qt::CTRL | Qt::Key_Delete));
    QAction& undo = add("scan.undo", tr("&Undo decision"), tr("There is no such decision on the map"),
                        QKeySequence(Qt::CTRL | Qt::Key_Z));
    QAction& redo = add("scan.redo", tr("Redo decision"), tr("There is no such decision on the map"),
                        QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z));
    connect(&next, &QAction::triggered, this, &DecisionsFeature::toNextUncertain);
    connect(&accept, &QAction::triggered, this,
            [this, &mapping] { answer(mapping.accept(m_panel->chosen())); });
    connect(&reject, &QAction::triggered, this,
            [this, &mapping] { answer(mapping.reject(m_panel->chosen())); });
    connect(&again, &QAction::triggered, this, &DecisionsFeature::retry);
    connect(&drag, &QAction::triggered, this, &DecisionsFeature::dragForRetry);
    connect(&loop, &QAction::triggered, this, &DecisionsFeature::dragForLoop);
    connect(&back, &QAction::triggered, this, &DecisionsFeature::rewind);
    connect(&undo, &QAction::triggered, this, [this, &mapping] { answer(mapping.undo()); });
    connect(&redo, &QAction::triggered, this, [this, &mapping] { answer(mapping.redo()); });
    next.setIconText(tr("Next ?"));
    accept.setIconText(tr("Accept"));
    reject.setIconText(tr("Reject"));
    again.setIconText(tr("Retry"));
    drag.setIconText(tr("From pose"));
    loop.setIconText(tr("Meets…"));
    back.setIconText(tr("Rewind"));
    for (QAction* one : {&undo, &redo}) one->setEnabled(false);
    undo.setIconText(tr("Undo"));
    redo.setIconText(tr("Redo"));
    for (QAction* one : {&accept, &reject, &again, &drag, &loop, &back}) m_onChosen[one->objectName()] = one;
    m_panel->setDecisions({&next, &undo, &accept, &reject, &again, &drag, &loop, &back, &redo});
}

void DecisionsFeature::addArea() {
    m_context.commands.separate(CommandMenu::Map);
    QAction& draw =
        add("map.area", tr("Draw map's a&rea"),
            tr("Click the corners of what belongs into the map, a double click ends: points of coming "
               "scans outside of it stay out"),
            {}, true);
    QAction& clear =
        add("map.everywhere", tr("Map e&verything"), tr("Nothing is outside of the map's area any more"));
    draw.setIconText(tr("Draw area"));
    clear.setIconText(tr("Everything"));
    StationMapping& mapping = m_context.mapping;
    connect(&draw, &QAction::triggered, this, &DecisionsFeature::drawArea);
    connect(&clear, &QAction::triggered, this, [this, &mapping] {
        MapCrop crop = mapping.crop();
        crop.polygon.clear();
        answer(mapping.setCrop(crop));
        showArea();
    });
    connect(m_panel, &DecisionsPanel::ceilingWanted, this,
            [this, &mapping](const std::optional<double>& height) {
                MapCrop crop = mapping.crop();
                crop.ceiling = height.value_or(MapCrop{}.ceiling);
                answer(mapping.setCrop(crop));
                showArea();
            });
    m_panel->setAreaCommands({&draw, &clear});
}

void DecisionsFeature::answer(const Result<void>& done) {
    if (!done) m_context.notify(QString::fromStdString(done.error().text));
}

void DecisionsFeature::toNextUncertain() {
    const std::uint64_t id = m_scans.uncertainBefore(m_panel->chosen());
    if (id == 0) {
        m_context.notify(tr("No scan waits for a decision"));
        return;
    }
    m_panel->choose(id);
    m_view.showScan(id);
}

void DecisionsFeature::retry() {
    RetrySettings settings;
    settings.match.wide = m_panel->retrySchedule();
    answer(m_context.mapping.retry(m_panel->chosen(), settings));
}

void DecisionsFeature::dragForRetry(bool on) {
    if (!on) return m_gestures.disarm();
    dragChosen(QStringLiteral("scan.retryFromPose"),
               tr("Click where the robot was at scan %1, drag its heading · right button: not at all"),
               [this](std::uint64_t id, const Pose& scanInMap) {
                   RetrySettings settings;
                   settings.match.wide = m_panel->retrySchedule();
                   settings.guessInMap = scanInMap;
                   answer(m_context.mapping.retry(id, settings));
               });
}

void DecisionsFeature::dragForLoop(bool on) {
    if (!on) return m_gestures.disarm();
    dragChosen(
        QStringLiteral("loop.draw"),
        tr("Click where the older part of the map has the place of scan %1, drag the robot's heading · "
           "right button: not at all"),
        [this](std::uint64_t id, const Pose& scanInMap) {
            answer(m_context.mapping.propose(id, scanInMap));
        });
}

void DecisionsFeature::dragChosen(const QString& command, const QString& text,
                                  const std::function<void(std::uint64_t, const Pose&)>& drawn) {
    const std::uint64_t id = m_panel->chosen();
    const LiveKeyScan* const scan = m_scans.scanAt(m_scans.rowOf(id));
    if (scan == nullptr) return m_gestures.disarm();
    RobotMark ghost = m_robots.mark(scan->scan->robot);
    ghost.baseInMap = scan->pose.scanInMap * scan->sensorInBase.inverse();
    m_view.setHighlighted(id);
    m_gestures.armPose(*m_onChosen.at(command), ghost, text.arg(id),
                       [this, id, drawn](const GroundPose& pose) {
                           const LiveKeyScan* const now = m_scans.scanAt(m_scans.rowOf(id));
                           if (now != nullptr) drawn(id, drawnPose(*now, pose));
                       });
}

void DecisionsFeature::rewind() {
    const LiveKeyScan* const scan = m_scans.scanAt(m_scans.rowOf(m_panel->chosen()));
    if (scan != nullptr) answer(m_context.mapping.rewind(scan->entered));
}

void DecisionsFeature::drawArea(bool on) {
    if (!on) return m_gestures.disarm();
    QAction& draw = *m_context.commands.find(QStringLiteral("map.area"));
    m_gestures.armArea(
        draw,
        tr("Click the corners of what belongs into the map, double click the last one · right button: "
           "takes a corner back"),
        [this](const std::vector<Eigen::Vector2d>& area) {
            StationMapping& mapping = m_context.mapping;
            MapCrop crop = mapping.crop();
            crop.polygon = area;
            answer(mapping.setCrop(crop));
            showArea();
        });
}

void DecisionsFeature::follow(const MissionState& mission) {
    const StationMapping& mapping = m_context.mapping;
    const MapCrop crop = mapping.crop();
    if (crop.polygon != m_area.polygon || crop.ceiling != m_area.ceiling) showArea();
    const std::uint64_t newest = mission.decisions->empty() ? 0 : mission.decisions->back().sequence;
    if (newest == m_newest) return;
    m_newest = newest;
    const auto undo = mapping.undoable(), redo = mapping.redoable();
    showUndo(QStringLiteral("scan.undo"), undo ? tr("Takes back: %1").arg(decisionText(*undo)) : QString(),
             undo ? tr("&Undo: %1").arg(decisionText(*undo)) : tr("&Undo decision"));
    showUndo(QStringLiteral("scan.redo"), redo ? tr("Decides again: %1").arg(decisionText(*redo)) : QString(),
             redo ? tr("Redo: %1").arg(decisionText(*redo)) : tr("Redo decision"));
}

void DecisionsFeature::showUndo(const QString& id, const QString& hint, const QString& text) {
    QAction& action = *m_context.commands.find(id);
    const QString icon = action.iconText();  // would follow the text otherwise
    action.setEnabled(!hint.isEmpty());
    action.setText(text);
    action.setIconText(icon);
    m_context.commands.setHint(id, hint.isEmpty() ? tr("There is no such decision on the map") : hint);
}

void DecisionsFeature::show() {
    const LiveKeyScan* const scan = m_scans.scanAt(m_scans.rowOf(m_panel->chosen()));
    for (const auto& [id, action] : m_onChosen) action->setEnabled(scan != nullptr);
    m_view.setHighlighted(scan == nullptr ? 0 : scan->id);
}

void DecisionsFeature::showArea() {
    const MapCrop crop = m_context.mapping.crop();
    m_area = crop;
    m_view.setArea(crop.polygon);
    m_panel->setCeiling(crop.ceiling < 1e9 ? std::optional(crop.ceiling) : std::nullopt);
    m_panel->setAreaText(crop.polygon.empty() ? tr("The whole world belongs into the map")
                                              : tr("What is outside the dashed line stays out of the map"));
    m_context.commands.find(QStringLiteral("map.everywhere"))->setEnabled(!crop.polygon.empty());
}

}  // namespace leitstand
