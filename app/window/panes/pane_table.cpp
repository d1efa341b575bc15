#include "app/window/panes/pane_table.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include <QCoreApplication>
#include <QMainWindow>

#include "app/services/coverage/coverage_replay.h"
#include "app/services/station/station.h"
#include "app/window/frame/pane_docks.h"
#include "app/window/input/selection.h"
#include "app/window/panes/alarms/alarms_feature.h"
#include "app/window/panes/alarms/logged_alarms.h"
#include "app/window/panes/camera/camera_feature.h"
#include "app/window/panes/changes/changes_feature.h"
#include "app/window/panes/compare/compare_feature.h"
#include "app/window/panes/coverage/coverage_feature.h"
#include "app/window/panes/drive/drive_feature.h"
#include "app/window/panes/drive/strip_feature.h"
#include "app/window/panes/finds/find_pointing.h"
#include "app/window/panes/finds/finds_by_click.h"
#include "app/window/panes/finds/finds_feature.h"
#include "app/window/panes/finds/victims_feature.h"
#include "app/window/panes/frames/frames_feature.h"

#include "app/window/panes/joints/joints_feature.h"
#include "app/window/panes/link/link_feature.h"
#include "app/window/panes/link/logged_streams.h"
#include "app/window/panes/map/decisions/decisions_feature.h"
#include "app/window/panes/map/decisions/loops_feature.h"
#include "app/window/panes/map/decisions/submap_feature.h"
#include "app/window/panes/map/map_actions.h"
#include "app/window/panes/map/map_feature.h"
#include "app/window/panes/messages/messages_feature.h"
#include "app/window/panes/readings/readings_feature.h"
#include "app/window/panes/scan/scan_feature.h"
#include "app/window/panes/score/hand_in_feature.h"
#include "app/window/panes/score/report_feature.h"
#include "app/window/panes/topics/topics_feature.h"
#include "app/window/source/review_bridge.h"
#include "core/event/stream_role.h"
#include "core/mission/state/find_state.h"
#include "core/mission/state/session_state.h"
#include "widgets/drive/drive_strip.h"
#include "widgets/map_view/map_view.h"
#include "widgets/messages/messages_panel.h"
#include "widgets/models/victims/victim_rows.h"

namespace leitstand {
namespace {

QWidget& loggedStrip(PaneMaking& from) {
    return (new StripFeature(from.view))->pane();
}

QWidget& liveStrip(PaneMaking& from) {
    DriveStrip& strip = (new StripFeature(from.view))->pane();
    from.made.drive = new DriveFeature(*from.live, strip);
    return strip;
}

QWidget& camera(PaneMaking& from) {
    from.made.cameras = new CameraFeature(from.view);
    return from.made.cameras->large();
}

QWidget& secondCamera(PaneMaking& from) {
    return from.made.cameras->small();
}

QWidget& map(PaneMaking& from) {
    from.made.map = new MapFeature(from.view, from.look);
    return from.made.map->pane();
}

QWidget& liveMap(PaneMaking& from) {
    QWidget& pane = map(from);
    from.made.actions = new MapActions(*from.live, *from.made.map);
    QObject::connect(&from.made.drive->input(), &DriveInput::halted, from.made.actions, &MapActions::halt);
    return pane;
}

QWidget& keyScans(PaneMaking& from) {
    return from.made.actions->keyScans();
}

QWidget& keyScansByHand(PaneMaking& from) {
    MapFeature& map = *from.made.map;
    auto* const decisions =
        new DecisionsFeature(*from.byHand, map.view(), map.gestures(), map.robots(), &map);
    new LoopsFeature(*from.byHand, map.view(), &map);
    new SubmapFeature(
        *from.byHand, map.view(), map.gestures(), [decisions] { return decisions->chosen(); }, &map);
    return decisions->pane();
}

QWidget& missed(PaneMaking& from) {
    const auto searched = [station = from.view.liveStation](const LiveMoment&) {
        return station->searched();
    };
    return (new CoverageFeature(from.view, *from.made.map, searched, from.made.actions))->pane();
}

QWidget& missedThen(PaneMaking& from) {
    ReviewBridge& review = from.review->review;
    const auto searched = [&review, replay = std::make_shared<CoverageReplay>(review.player().folder())](
                              const LiveMoment& moment) {
        if (review.index() && moment.mission && moment.places)
            replay->want({moment.now, moment.mission, moment.places, review.index()});
        return replay->searched();
    };
    return (new CoverageFeature(from.view, *from.made.map, searched))->pane();
}

QWidget& changes(PaneMaking& from) {
    return (new ChangesFeature(from.view, *from.made.map))->pane();
}

QWidget& surroundings(PaneMaking& from) {
    from.made.scan = new ScanFeature(from.view);
    return from.made.scan->pane();
}

QWidget& joints(PaneMaking& from) {
    from.made.joints = new JointsFeature(from.view);
    return from.made.joints->pane();
}

bool hasJoints(const PaneMaking& from) {
    const auto& robots = from.view.selection.robots();
    return std::any_of(robots.begin(), robots.end(),
                       [](const RobotDescription& robot) { return !robot.jointGroups.empty(); });
}

QWidget& readings(PaneMaking& from) {
    return (new ReadingsFeature(from.view))->pane();
}

bool hasReadings(const PaneMaking& from) {
    const auto& robots = from.view.selection.robots();
    return std::any_of(robots.begin(), robots.end(), [](const RobotDescription& robot) {
        return robot.stream(StreamRole::Reading) != nullptr;
    });
}

QWidget& victims(PaneMaking& from) {
    from.made.victims = new VictimsFeature(*from.live, *from.made.map, *from.made.cameras);
    new FindPointing(*from.live, *from.made.map, *from.made.cameras, *from.made.scan);
    return from.made.victims->list();
}

QWidget& victimForm(PaneMaking& from) {
    return from.made.victims->form();
}

QWidget& finds(PaneMaking& from) {
    FindsFeature* const made = from.made.finds = new FindsFeature(*from.review);
    new FindsByClick(*from.review, *from.made.map, *from.made.cameras, *from.made.scan, *made);
    QObject::connect(made, &FindsFeature::findsChanged, from.made.map, [made, map = from.made.map] {
        map->view().setFinds(victimRows(made->state(), std::nullopt), made->chosen());
    });
    return made->list();
}

QWidget& findForm(PaneMaking& from) {
    return from.made.finds->form();
}

QWidget& liveScore(PaneMaking& from) {
    return (new ReportFeature(*from.live))->pane();
}

QWidget& loggedScore(PaneMaking& from) {
    return (new HandInFeature(*from.review, *from.made.finds))->pane();
}

QWidget& link(PaneMaking& from) {
    from.made.link = new LinkFeature(*from.live);
    return from.made.link->pane();
}

QWidget& loggedStreams(PaneMaking& from) {
    return (new LoggedStreams(*from.review))->pane();
}

QWidget& alarms(PaneMaking& from) {
    from.made.alarms = new AlarmsFeature(*from.live);
    return from.made.alarms->pane();
}

QWidget& loggedAlarms(PaneMaking& from) {
    return (new LoggedAlarms(*from.review))->pane();
}

QWidget& compare(PaneMaking& from) {
    from.made.compare = new CompareFeature(*from.review, *from.made.map);
    return from.made.compare->pane();
}

QWidget& topics(PaneMaking& from) {
    return (new TopicsFeature(*from.live))->pane();
}

QWidget& frames(PaneMaking& from) {
    return (new FramesFeature(*from.live))->pane();
}

QWidget& messages(PaneMaking& from) {
    return (new MessagesFeature(from.view))->pane();
}

using Kind = PaneRow::Kind;
constexpr PaneRow Table[] = {
    {"strip", QT_TRANSLATE_NOOP("Panes", "Robot"), liveStrip, loggedStrip, Kind::Kept},
    {"camera", QT_TRANSLATE_NOOP("Panes", "Camera"), camera, camera, Kind::Kept},
    {"right", QT_TRANSLATE_NOOP("Panes", "Second camera"), secondCamera, secondCamera},
    {"map", QT_TRANSLATE_NOOP("Panes", "3D map"), liveMap, map, Kind::Kept, 1, "", map},
    {"key-scans", QT_TRANSLATE_NOOP("Panes", "Scans and decisions"), keyScans, nullptr, Kind::Plain, 3,
     "scans", keyScansByHand},
    {"missed", QT_TRANSLATE_NOOP("Panes", "Missed"), missed, missedThen, Kind::Plain, 4},
    {"changes", QT_TRANSLATE_NOOP("Panes", "Changed"), changes, changes},
    {"surroundings", QT_TRANSLATE_NOOP("Panes", "Virtual scan"), surroundings, surroundings, Kind::Plain, 0,
     "scan"},
    {"joints", QT_TRANSLATE_NOOP("Panes", "Flippers and arm"), joints, joints, Kind::Plain, 0, "", nullptr,
     hasJoints},
    {"readings", QT_TRANSLATE_NOOP("Panes", "Readings"), readings, readings, Kind::Plain, 0, "", nullptr,
     hasReadings},
    {"victims", QT_TRANSLATE_NOOP("Panes", "Victims"), victims, nullptr},
    {"finds", QT_TRANSLATE_NOOP("Panes", "Finds"), nullptr, finds, Kind::Plain, 6},
    {"form", QT_TRANSLATE_NOOP("Panes", "Form"), victimForm, findForm, Kind::Sheet},
    {"score", QT_TRANSLATE_NOOP("Panes", "Score"), liveScore, loggedScore, Kind::Plain, 5},
    {"link", QT_TRANSLATE_NOOP("Panes", "Link"), link, loggedStreams, Kind::Plain, 2},
    {"topics", QT_TRANSLATE_NOOP("Panes", "Topics"), topics, nullptr},
    {"frames", QT_TRANSLATE_NOOP("Panes", "Frames"), frames, nullptr},
    {"alarms", QT_TRANSLATE_NOOP("Panes", "Alarms"), alarms, loggedAlarms, Kind::Kept},
    {"compare", QT_TRANSLATE_NOOP("Panes", "Compare"), nullptr, compare, Kind::Plain, 7},
    {"messages", QT_TRANSLATE_NOOP("Panes", "Messages"), messages, messages, Kind::Plain, 0, "", messages},
};

QStringList sheetHosts() {
    std::vector<PaneRow> hosts;
    std::copy_if(std::begin(Table), std::end(Table), std::back_inserter(hosts),
                 [](const PaneRow& row) { return row.hostRank > 0; });
    std::sort(hosts.begin(), hosts.end(),
              [](const PaneRow& a, const PaneRow& b) { return a.hostRank < b.hostRank; });
    QStringList ids;
    for (const PaneRow& row : hosts) ids += QLatin1String(row.id);
    return ids;
}

PaneRow::Make makerFor(const PaneMaking& from, const PaneRow& row) {
    if (from.live != nullptr) return row.live;
    return from.review != nullptr ? row.review : row.byHand;
}

PaneFeatures makeAll(PaneMaking from) {
    PaneDocks& docks = from.view.panes;
    for (const PaneRow& row : Table) {
        const PaneRow::Make make = makerFor(from, row);
        if (make == nullptr || (row.needed != nullptr && !row.needed(from))) continue;
        const QString id = QLatin1String(row.id);
        const QString title = QCoreApplication::translate("Panes", row.title);
        docks.add(id, title, make(from), QLatin1String(row.formerId));
        if (row.kind == Kind::Kept) docks.keepInSight(id);
        if (row.kind == Kind::Sheet) docks.addSheet(id, sheetHosts());
    }
    return from.made;
}

}  // namespace

std::span<const PaneRow> paneTable() {
    return Table;
}

PaneFeatures makePanes(const LiveContext& context, const MapViewSettings& look) {
    return makeAll({.view = context, .look = look, .live = &context});
}

PaneFeatures makePanes(const ReviewContext& context, const MapViewSettings& look) {
    return makeAll({.view = context, .look = look, .review = &context});
}

PaneFeatures makePanes(const MapContext& context, const MapViewSettings& look) {
    return makeAll({.view = context, .look = look, .byHand = &context});
}

}  // namespace leitstand
