#include "app/window/panes/map/decisions/submap_feature.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include <QAction>
#include <QApplication>
#include <QKeySequence>
#include <QMetaObject>
#include <QPointer>

#include "app/services/mapping/live_mapping.h"
#include "app/services/station/station_mapping.h"
#include "app/window/commands/command_table.h"
#include "app/window/input/selection.h"
#include "app/window/panes/map/decisions/robot_title.h"
#include "app/window/panes/map/map_gestures.h"
#include "app/window/source/live_moment.h"
#include "app/window/source/moment_source.h"
#include "widgets/map_decisions/map_question.h"
#include "widgets/map_view/map_view.h"
#include "widgets/models/numbers.h"

namespace leitstand {
namespace {

constexpr std::array Kinds = {SubmapKind::FromHere, SubmapKind::Robot, SubmapKind::Storey, SubmapKind::Part,
                              SubmapKind::Scan};

const LiveKeyScan* scanOf(const LiveMap& map, std::uint64_t id) {
    const auto found = std::find_if(map.scans.begin(), map.scans.end(),
                                    [id](const LiveKeyScan& scan) { return scan.id == id; });
    return found == map.scans.end() ? nullptr : &*found;
}

}  // namespace

SubmapFeature::SubmapFeature(const MapContext& context, MapView& view, MapGestures& gestures,
                             std::function<std::uint64_t()> chosen, QObject* parent)
    : QObject(parent), m_context(context), m_view(view), m_gestures(gestures), m_chosen(std::move(chosen)) {
    addCommands();
    m_bar = new MapQuestion(QStringLiteral("submapBar"), {m_more, m_snap, m_leave, m_move}, m_view);
    connect(&context.source, &MomentSource::ticked, this, &SubmapFeature::follow);
}

void SubmapFeature::addCommands() {
    m_context.commands.separate(CommandMenu::Map);
    m_move = &m_context.commands.add(
        {.id = QStringLiteral("submap.move"),
         .menu = CommandMenu::Map,
         .text = tr("Move a part of the map by &hand"),
         .hint =
             tr("A run of scans, a robot's, a storey, a part that has not met the rest, or one scan alone: "
                "drag it to where it belongs, Shift+drag turns it"),
         .keys = QKeySequence(Qt::SHIFT | Qt::Key_K),
         .checkable = true});
    const auto add = [this](const QString& id, const QString& text, const QString& hint,
                            const QKeySequence& keys) {
        QAction& action = m_context.commands.add(
            {.id = id, .menu = CommandMenu::Map, .text = text, .hint = hint, .keys = keys});
        action.setEnabled(false);
        return &action;
    };
    m_more =
        add(QStringLiteral("submap.more"), tr("Move &more of the map, or less"),
            tr("From the chosen scan on, all of its robot, its storey, its part of the map, this scan alone"),
            QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_K));
    m_snap = add(QStringLiteral("submap.snap"), tr("&Snap the moved part"),
                 tr("Lays the moved part onto the rest of the map, from where it is"),
                 QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_S));
    m_leave = add(QStringLiteral("submap.leave"), tr("&Leave the moved part there"),
                  tr("Its scans are linked with those that they lie on, and the map follows"),
                  QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_P));
    m_move->setIconText(tr("Cancel"));
    m_more->setIconText(tr("More"));
    m_snap->setIconText(tr("Snap"));
    m_leave->setIconText(tr("Leave there"));
    connect(m_move, &QAction::triggered, this, [this](bool on) { on ? begin() : m_gestures.disarm(); });
    connect(m_more, &QAction::triggered, this, &SubmapFeature::next);
    connect(m_snap, &QAction::triggered, this, &SubmapFeature::snap);
    connect(m_leave, &QAction::triggered, this, &SubmapFeature::leave);
    connect(m_move, &QAction::toggled, this, [this](bool on) {
        if (!on && m_moving) end();  // also when another gesture began
    });
}

std::uint64_t SubmapFeature::scanToMove() const {
    const LiveMapPtr map = m_context.mapping.scans();
    const LiveKeyScan* const chosen = scanOf(*map, m_chosen());
    if (chosen != nullptr && chosen->counts()) return chosen->id;
    // Else the newest of the selected robot, or of any.
    std::uint64_t newest = 0, own = 0;
    for (const LiveKeyScan& scan : map->scans) {
        if (!scan.counts()) continue;
        newest = scan.id;
        if (scan.scan->robot == m_context.selection.name().toStdString()) own = scan.id;
    }
    return own != 0 ? own : newest;
}

void SubmapFeature::begin() {
    if (!m_context.mapping.makesMap()) {
        m_move->setChecked(false);
        m_context.notify(tr("Another station makes the map: it is moved there"));
        return;
    }
    m_scan = scanToMove();
    m_map = m_context.mapping.scans();
    m_moved = Pose::Identity();
    m_kind = SubmapKind::FromHere;
    const LiveKeyScan* const scan = scanOf(*m_map, m_scan);
    if (scan != nullptr && scan->part != 0) m_kind = SubmapKind::Part;  // most often this is to be moved
    for (std::size_t i = 0; i < Kinds.size() && submapOf(*m_map, m_scan, m_kind).empty(); ++i)
        m_kind = Kinds[i];
    if (submapOf(*m_map, m_scan, m_kind).empty()) {
        m_move->setChecked(false);
        m_context.notify(tr("There is no part of the map that could be moved against the rest"));
        return;
    }
    m_gestures.armGrab(*m_move,
                       tr("Drag: moves the violet part · Shift+drag: turns it · right button: not at all"),
                       [this](const GroundDrag& one) { drag(one); });
    m_moving = true;
    take();
}

void SubmapFeature::take() {
    m_submap = submapOf(*m_map, m_scan, m_kind);
    m_fits.begin(m_map, m_submap, leftBehind(*m_map, m_scan, m_kind));
    m_fits.want(m_moved);
    m_snapping = false;
    m_grabbed = m_moved;
    show();
}

void SubmapFeature::next() {
    if (!m_moving || m_leaving) return;
    auto at = std::find(Kinds.begin(), Kinds.end(), m_kind);
    const std::set<std::uint64_t> before = m_submap;
    for (std::size_t i = 0; i < Kinds.size(); ++i) {
        at = at + 1 == Kinds.end() ? Kinds.begin() : at + 1;
        const auto scans = submapOf(*m_map, m_scan, *at);
        if (scans.empty() || scans == before) continue;
        m_kind = *at;
        m_moved = Pose::Identity();
        return take();
    }
    m_context.notify(tr("No other part of the map could be moved against the rest"));
}

void SubmapFeature::end() {
    m_moving = m_snapping = m_leaving = false;
    m_fits.end();
    m_map.reset();
    m_submap.clear();
    show();
}

void SubmapFeature::drag(const GroundDrag& drag) {
    const SubmapOnMapPtr submap = m_fits.submap();
    if (drag.begins) m_grabbed = m_moved;
    if (!m_moving || !submap || m_snapping || m_leaving) return;
    if (!drag.turns) {
        Eigen::Vector3d way = drag.to - drag.from;
        way.z() = 0.0;
        return moveTo(Eigen::Translation3d(way) * m_grabbed);
    }
    const Eigen::Vector3d middle = m_grabbed * submap->middle();
    const Eigen::Vector2d from = (drag.from - middle).head<2>(), to = (drag.to - middle).head<2>();
    constexpr double Least = 0.05;  // distance from the middle; nearer to it a direction means nothing [m]
    if (from.norm() < Least || to.norm() < Least) return;
    const double turn = std::atan2(to.y(), to.x()) - std::atan2(from.y(), from.x());
    moveTo(Eigen::Translation3d(middle) * Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()) *
           Eigen::Translation3d(-middle) * m_grabbed);
}

void SubmapFeature::moveTo(const Pose& moved) {
    m_moved = moved;
    m_fits.want(moved);
    show();
}

void SubmapFeature::snap() {
    if (!m_moving || m_snapping || m_leaving || !m_fits.submap()) return;
    m_snapping = true;
    m_fits.snap(m_moved);
    show();
}

void SubmapFeature::leave() {
    if (!m_moving || m_leaving || m_snapping || !m_fits.submap()) return;
    const LiveKeyScan* const scan = scanOf(*m_map, m_scan);
    if (scan == nullptr) return;
    const auto answered = [guard = QPointer<SubmapFeature>(this),
                           source = QPointer<MomentSource>(&m_context.source),
                           asked = ++m_asked](Result<std::size_t> links) {
        QMetaObject::invokeMethod(qApp, [guard, source, asked, links = std::move(links)] {
            if (guard && guard->m_leaving && guard->m_asked == asked) guard->left(links);
            // The window was closed meanwhile: the source notifies the next one.
            if (!guard && source && !links) source->notify(QString::fromStdString(links.error().text));
        });
    };
    m_leaving = true;
    const auto asked = m_context.mapping.moveTo(m_scan, m_kind, m_moved * scan->pose.scanInMap, answered);
    if (!asked) return left(asked.error());
    show();
}

void SubmapFeature::left(const Result<std::size_t>& links) {
    if (!links) m_context.notify(QString::fromStdString(links.error().text));
    m_leaving = false;
    if (links) {
        m_context.notify(tr("Left there; links to the rest of the map: %1").arg(*links));
        m_gestures.disarm();
    }
    show();
}

void SubmapFeature::follow() {
    if (!m_moving) return;
    if (const auto snapped = m_fits.takeSnapped()) {
        m_snapping = false;
        if (snapped->moved)
            moveTo(*snapped->moved);
        else
            m_context.notify(tr("Too little of it lies on the rest of the map there: drag it nearer first"));
    }
    if (m_leaving) return;  // the map moves with it, maybe before the answer arrives
    const LiveMapPtr now = m_context.mapping.scans();
    if (now != m_map && scansMoved(m_map, *now)) {
        m_map = now;
        if (submapOf(*m_map, m_scan, m_kind).empty()) {
            m_gestures.disarm();
            m_context.notify(tr("The map has changed: what was moved is not there any more"));
            return;
        }
        return take();
    }
    show();
}

QString SubmapFeature::what() const {
    const LiveKeyScan* const scan = scanOf(*m_map, m_scan);
    if (scan == nullptr) return {};
    const QString robot = titleOfRobot(m_context.source.robots(), scan->scan->robot);
    const QString count = QString::number(m_submap.size());
    switch (m_kind) {
        case SubmapKind::FromHere:
            return tr("%1 from scan %2 on (scans: %3)").arg(robot).arg(m_scan).arg(count);
        case SubmapKind::Robot:
            return tr("all of %1 (scans: %2)").arg(robot, count);
        case SubmapKind::Storey:
            return tr("the storey of scan %1 (scans: %2)").arg(m_scan).arg(count);
        case SubmapKind::Scan:
            return tr("scan %1 of %2 alone").arg(m_scan).arg(robot);
        case SubmapKind::Part:
            break;
    }
    return tr("the part of the map with scan %1 (scans: %2)").arg(m_scan).arg(count);
}

QString SubmapFeature::text() const {
    QString text = what() + QLatin1Char('\n');
    const auto fit = m_fits.fit();
    if (m_snapping || m_leaving) return text + tr("It is laid onto the rest of the map…");
    if (!m_fits.submap() || !fit) return text + tr("It is made ready…");
    if (!(fit->overlap > 0.0)) return text + tr("Nothing of the rest of the map is there");
    return text + tr("On the rest of the map: %1, seam %2 m")
                      .arg(percentText(fit->overlap), numberText(fit->seam, 2));
}

void SubmapFeature::show() {
    const SubmapOnMapPtr submap = m_fits.submap();
    m_view.setDragged(m_moving && submap ? submap->places(m_moved) : std::map<std::uint64_t, Pose>());
    m_bar->ask(m_moving ? text() : QString());
    m_more->setEnabled(m_moving && !m_leaving);
    for (QAction* one : {m_snap, m_leave}) one->setEnabled(m_moving && submap && !m_snapping && !m_leaving);
}

}  // namespace leitstand
