#include "app/window/panes/map/go_to.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include <QAction>

#include "app/services/station/station.h"
#include "app/services/station/station_mapping.h"
#include "app/window/commands/command_table.h"
#include "app/window/input/selection.h"
#include "app/window/panes/map/goal_question.h"
#include "app/window/panes/map/map_gestures.h"
#include "app/window/panes/map/robots_on_map.h"
#include "app/window/source/moment_source.h"
#include "core/event/motion_samples.h"
#include "core/event/status_samples.h"
#include "core/event/stream_role.h"
#include "core/mapping/live/map/moved_places.h"
#include "core/robot/goal.h"
#include "widgets/map_view/map_view.h"
#include "widgets/models/live/texts/goal_text.h"
#include "widgets/models/others_text.h"

namespace leitstand {
namespace {

constexpr double Arrived = 0.4;               ///< [m]
constexpr std::chrono::seconds Patience(10);  ///< wait for the grant, and for the robot to begin
constexpr std::size_t MostNext = 20;          ///< places after the goal
constexpr auto DrivesByItself = "explore";    ///< mode in which robots drive to goals

bool offers(const RobotState& reported, const std::string& mode) {
    if (!reported.mode) return false;
    const auto& modes = reported.mode->sample.available;
    return std::find(modes.begin(), modes.end(), mode) != modes.end();
}

bool moves(const RobotState& reported) {
    constexpr double Still = 0.02;  // [m/s, rad/s]
    return reported.odometry && (reported.odometry->sample.linear.norm() > Still ||
                                 reported.odometry->sample.angular.norm() > Still);
}

}  // namespace

GoTo::GoTo(const LiveContext& context, MapView& map, MapGestures& gestures, RobotsOnMap& robots,
           QObject* parent)
    : QObject(parent),
      m_context(context),
      m_gestures(gestures),
      m_robots(robots),
      m_action(&context.commands.add(
          {.id = "map.goTo",
           .menu = CommandMenu::Map,
           .text = tr("&Go to a place"),
           .hint = tr(
               "Click where the selected robot shall go by itself, drag its heading; a double click on the "
               "floor does the same"),
           .keys = QKeySequence(Qt::Key_O),
           .checkable = true})),
      m_nextAction(&context.commands.add(
          {.id = "map.goToNext",
           .menu = CommandMenu::Robot,
           .text = tr("Go there &next"),
           .hint = tr("Click where the selected robot shall go after the place that it is sent to now"),
           .keys = QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_O),
           .checkable = true})),
      m_returnAction(&context.commands.add(
          {.id = "map.returnToStart",
           .menu = CommandMenu::Robot,
           .text = tr("Return to &start"),
           .hint = tr("Sends the selected robot to where its trail in the map begins")})),
      m_question(new GoalQuestion(context.commands, map, this)),
      m_map(context.station.mapping().scans()) {
    connect(m_action, &QAction::triggered, this, [this](bool on) {
        arm(*m_action, on, tr("Click where %1 shall go, drag its heading · right button: not at all"),
            &GoTo::go);
    });
    connect(m_nextAction, &QAction::triggered, this, [this](bool on) {
        arm(*m_nextAction, on,
            tr("Click where %1 shall go next, drag its heading · right button: not at all"), &GoTo::goNext);
    });
    connect(m_returnAction, &QAction::triggered, this, &GoTo::returnToStart);
    connect(m_question, &GoalQuestion::confirmed, this, &GoTo::begin);
    connect(&context.selection, &Selection::changed, this, &GoTo::showSelected);
    connect(&context.source, &MomentSource::ticked, this, &GoTo::follow);
    connect(&context.source, &MomentSource::scansChanged, this, &GoTo::followMap);
    showSelected();
}

void GoTo::showSelected() {
    const RobotDescription* const robot = m_context.selection.robot();
    for (QAction* const action : {m_action, m_nextAction, m_returnAction})
        action->setEnabled(robot != nullptr && robot->takesGoals());
    if (m_action->isChecked() || m_nextAction->isChecked()) m_gestures.disarm();
}

void GoTo::arm(QAction& action, bool on, const QString& hint, void (GoTo::*then)(const GroundPose&)) {
    const std::string robot = m_context.selection.name().toStdString();
    if (!on) return m_gestures.disarm();
    if (!maySend()) return action.setChecked(false);
    m_gestures.armPose(action, m_robots.mark(robot), hint.arg(m_context.selection.face().title),
                       [this, then](const GroundPose& pose) { (this->*then)(pose); });
}

bool GoTo::maySend() const {
    const RobotDescription* const robot = m_context.selection.robot();
    if (robot == nullptr) return false;
    const QString title = m_context.selection.face().title;
    if (!m_action->isEnabled()) {
        m_context.notify(tr("%1 takes no goals").arg(title));
    } else if (!m_robots.placed(robot->name)) {
        m_context.notify(tr("%1 is not in the map yet").arg(title));
    } else {
        return true;
    }
    return false;
}

Pose GoTo::headed(const GroundPose& pose, const Eigen::Vector3d& from) {
    const Eigen::Vector3d way = pose.place - from;
    return poseFrom(pose.place, 0, 0, pose.heading.value_or(std::atan2(way.y(), way.x())));
}

void GoTo::go(const GroundPose& pose) {
    if (!maySend()) return;
    const std::string robot = m_context.selection.name().toStdString();
    begin(robot, headed(pose, m_robots.mark(robot).baseInMap.translation()));
}

void GoTo::goNext(const GroundPose& pose) {
    const std::string robot = m_context.selection.name().toStdString();
    const auto way = m_ways.find(robot);
    if (way == m_ways.end()) return go(pose);
    std::vector<Pose>& next = way->second.next;
    if (next.size() >= MostNext)
        return m_context.notify(
            tr("%1 is sent to %2 places already").arg(m_context.selection.face().title).arg(MostNext + 1));
    const Pose& before = next.empty() ? way->second.goalInMap : next.back();
    next.push_back(headed(pose, before.translation()));
    showWay(robot);
}

void GoTo::returnToStart() {
    if (!maySend()) return;
    const std::string robot = m_context.selection.name().toStdString();
    const TrailPtr trail = m_robots.mark(robot).trail;
    if (!trail || trail->empty())
        return m_context.notify(
            tr("%1 has not driven yet: it has no start to return to").arg(m_context.selection.face().title));
    go({trail->front().inMap.cast<double>(), std::nullopt});
}

void GoTo::showWay(const std::string& robot) {
    const auto way = m_ways.find(robot);
    if (way == m_ways.end()) return m_robots.setGoal(robot, std::nullopt);
    m_robots.setGoal(robot, way->second.goalInMap, way->second.next);
}

void GoTo::begin(const std::string& robot, const Pose& goalInMap) {
    // Checked before another station is asked for its grant.
    if (const auto may = m_context.station.maySend(robot); !may)
        return m_context.notify(QString::fromStdString(may.error().text));
    m_context.station.requestGrant(robot);
    m_ways[robot] = {goalInMap, m_context.source.moment().now};
    showWay(robot);
    m_question->forget(robot);
}

void GoTo::takeBack() {
    const std::string robot = m_context.selection.name().toStdString();
    m_question->forget(robot);
    const auto way = m_ways.find(robot);
    if (way == m_ways.end()) return;
    if (way->second.sent && !way->second.followed) return dropNext(robot, way->second);
    const QString title = m_context.selection.face().title;
    m_context.notify((way->second.sent ? tr("%1: its goal is cancelled, since it was halted")
                                       : tr("%1 is not sent: it was halted"))
                         .arg(title));
    if (way->second.sent) m_context.station.cancelGoal(robot);
    m_robots.setGoal(robot, std::nullopt);
    m_ways.erase(way);
}

std::optional<RobotInMap> GoTo::placeOf(const std::string& robot) const {
    const RobotsInMapPtr places = m_context.station.mapping().robots();
    const auto place = std::find_if(places->begin(), places->end(),
                                    [&robot](const RobotInMap& one) { return one.robot == robot; });
    if (place == places->end() || !place->placed || !place->odomInMap) return std::nullopt;
    return *place;
}

QString GoTo::titleOf(const std::string& robot) const {
    const RobotDescription* const known = m_context.selection.find(QString::fromStdString(robot));
    return known == nullptr ? othersText(robot) : m_context.selection.faceOfRobot(*known).title;
}

bool GoTo::send(const std::string& robot, const Way& way, const LiveMoment& moment) {
    const RobotState& reported = moment.reported(robot);
    const RobotDescription* const known = m_context.selection.find(QString::fromStdString(robot));
    const auto place = placeOf(robot);
    if (!reported.odometry || known == nullptr || !place) return false;
    // The robot does not know our map: the goal is sent in its own odometry frame. Not by the newest
    // odometry: while a scan is registered, that is of a later moment than the place in the map.
    PoseSample goal;
    goal.header.frame = known->odomFrame.empty() ? reported.odometry->sample.header.frame : known->odomFrame;
    goal.poseInFrame =
        goalInOdom(place->baseInMap, place->odomInMap->inverse() * place->baseInMap, way.goalInMap);
    Station& station = m_context.station;
    Result<void> done = station.goTo(robot, goal);
    if (done && offers(reported, DrivesByItself)) done = station.setMode(robot, DrivesByItself);
    if (!done) m_context.notify(QString::fromStdString(done.error().text));
    return done.ok();
}

GoTo::Ending GoTo::over(const std::string& robot, Way& way, const LiveMoment& moment) {
    const bool late = moment.now - way.asked > Patience;
    if (!way.sent) {
        // A stop also cancels what was requested before it.
        const StopStatus& stop = moment.view(robot).stop;
        if (stop.sent || stop.stopped || stop.releasing) return Ending::Otherwise;
        const bool mine = moment.view(robot).grant.mine;
        if (mine && placeOf(robot)) {
            if (!send(robot, way, moment)) return Ending::Otherwise;
            way.sent = true;
            way.asked = moment.now;
            // Of a goal that went by the topic, it tells of the one before at most, and that has ended.
            way.followed = !goalNote(m_context.station.robot(robot).navigation).isEmpty();
        } else if (late) {
            m_context.notify((mine ? tr("%1 was not sent: its odometry restarted, and nobody knows where")
                                   : tr("%1 was not sent: another station has its drive control"))
                                 .arg(titleOf(robot)));
            return Ending::Otherwise;
        }
        return Ending::No;
    }
    if (way.followed) return endOf(robot, moment);
    const RobotState& reported = moment.reported(robot);
    const bool drives = reported.mode && reported.mode->sample.mode == DrivesByItself;
    way.began = way.began || drives;
    const RobotMark mark = m_robots.mark(robot);
    const bool there =
        (mark.baseInMap.translation() - way.goalInMap.translation()).head<2>().norm() < Arrived;
    if (there) return Ending::Arrived;
    if (offers(reported, DrivesByItself) && !drives && (way.began || late)) return Ending::Otherwise;
    if (!way.began || moves(reported)) way.moved = moment.now;
    // It has come as near as it can, or gave up.
    return moment.now - way.moved > Patience ? Ending::Otherwise : Ending::No;
}

GoTo::Ending GoTo::endOf(const std::string& robot, const LiveMoment& moment) {
    const RobotView& view = moment.view(robot);
    // As it is now: the moment may have been taken before this goal was sent, and tell of the one before.
    const GoalStage stage = m_context.station.robot(robot).navigation.stage;
    if (const QString end = goalEnd(stage); !end.isEmpty()) {
        // After a stop everybody knows why.
        if (!view.stop.sent && !view.stop.stopped) m_context.notify(end.arg(titleOf(robot)));
        return stage == GoalStage::Arrived ? Ending::Arrived : Ending::Otherwise;
    }
    if (view.drive.driving && !isZero(view.drive.velocity)) {
        m_context.station.cancelGoal(robot);  // else both would drive it
        m_context.notify(tr("%1: its goal is cancelled, since you drive").arg(titleOf(robot)));
        return Ending::Otherwise;
    }
    return Ending::No;
}

bool GoTo::isHeldBack(const std::string& robot, const LiveMoment& moment) {
    const RobotView& view = moment.view(robot);
    const bool stopped = view.stop.sent || view.stop.stopped || view.stop.releasing;
    return stopped || !view.grant.mine || (view.drive.driving && !isZero(view.drive.velocity));
}

void GoTo::dropNext(const std::string& robot, Way& way) {
    if (way.next.empty()) return;
    way.next.clear();
    showWay(robot);
    const StopStatus& stop = m_context.source.moment().view(robot).stop;
    if (!stop.sent && !stop.stopped)
        m_context.notify(tr("%1: where it was to go next is given up").arg(titleOf(robot)));
}

bool GoTo::goOn(const std::string& robot, Way& way, Ending ending) {
    if (ending != Ending::Arrived) dropNext(robot, way);
    if (way.next.empty()) return false;
    Way on{way.next.front(), m_context.source.moment().now};
    on.next.assign(way.next.begin() + 1, way.next.end());
    way = std::move(on);
    showWay(robot);
    return true;
}

void GoTo::follow(const LiveMoment& moment) {
    for (const std::string& robot : m_question->robots()) {
        const StopStatus& stop = moment.view(robot).stop;
        if (stop.sent || stop.stopped || stop.releasing) m_question->forget(robot);
    }
    for (auto way = m_ways.begin(); way != m_ways.end();) {
        // A goal that only the robot knows cannot be taken back; it is not sent on from there.
        if (way->second.sent && isHeldBack(way->first, moment)) dropNext(way->first, way->second);
        const Ending ending = over(way->first, way->second, moment);
        if (ending == Ending::No || goOn(way->first, way->second, ending)) {
            ++way;
            continue;
        }
        const std::string robot = way->first;
        way = m_ways.erase(way);
        showWay(robot);
    }
}

bool GoTo::underWay(const std::string& robot, const Way& way) const {
    const LiveMoment& moment = m_context.source.moment();
    const StopStatus& stop = moment.view(robot).stop;
    if (!way.sent || stop.sent || stop.stopped || stop.releasing) return false;
    if (way.followed) return true;
    const RobotState& reported = moment.reported(robot);
    const bool drives = reported.mode && reported.mode->sample.mode == DrivesByItself;
    // The goal was sent, and the robot has not reported since: it is about to begin.
    const bool begins = !way.began && (!reported.mode || reported.mode->received <= way.asked);
    return drives || begins || !offers(reported, DrivesByItself);
}

void GoTo::stay(const std::string& robot) {
    // Its present pose becomes its goal: a robot knows goals, but not that one is withdrawn. In its odometry,
    // because its place in a map that moves is doubtful.
    const RobotState& reported = m_context.source.moment().reported(robot);
    const RobotDescription* const known = m_context.selection.find(QString::fromStdString(robot));
    if (!reported.odometry || known == nullptr) return;
    PoseSample here;
    here.header.frame = known->odomFrame.empty() ? reported.odometry->sample.header.frame : known->odomFrame;
    here.poseInFrame = reported.odometry->sample.baseInOdom;
    if (const auto done = m_context.station.goTo(robot, here); !done)
        m_context.notify(QString::fromStdString(done.error().text));
}

void GoTo::withdraw(const std::string& robot, const Way& way, const Pose& correction) {
    const bool goes = underWay(robot, way);
    if (goes && way.followed) {
        m_context.station.cancelGoal(robot);
    } else if (goes) {
        stay(robot);
    }
    m_robots.setGoal(robot, std::nullopt);
    if (goes || !way.sent)
        m_question->ask(robot, titleOf(robot), way.goalInMap, correction * way.goalInMap);
    else
        m_context.notify(
            tr("%1: the map moved under its goal, which is withdrawn; send it again").arg(titleOf(robot)));
}

void GoTo::followMap(const LiveMapPtr& map) {
    const LiveMapPtr before = std::exchange(m_map, map);
    if (!before || (m_ways.empty() && m_question->robots().empty())) return;
    const MovedPlaces places(*before, *map);
    if (places.any()) m_question->follow(places);
    for (auto one = m_ways.begin(); places.any() && one != m_ways.end();) {
        auto& [robot, way] = *one;
        bool moved = false;
        for (auto place = way.next.begin(); place != way.next.end(); ++place) {
            const Pose there = places.at(place->translation());
            const GoalMove move = goalMove(*place, there, true);
            if (move == GoalMove::Withdrawn) {
                dropNext(robot, way);  // nobody confirmed where it would go
                break;
            }
            moved = moved || move == GoalMove::Moves;
            *place = there * *place;
        }
        if (moved) showWay(robot);
        const Pose correction = places.at(way.goalInMap.translation());
        const GoalMove move = goalMove(way.goalInMap, correction, underWay(robot, way));
        if (move == GoalMove::Withdrawn) {
            dropNext(robot, way);
            withdraw(robot, way, correction);
            one = m_ways.erase(one);
            continue;
        }
        if (move == GoalMove::Moves) {
            way.goalInMap = correction * way.goalInMap;
            showWay(robot);
            (void)send(robot, way, m_context.source.moment());
        }
        ++one;
    }
}

}  // namespace leitstand
