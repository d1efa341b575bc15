#include "app/services/review/review_scene.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <utility>

#include "app/services/mapping/live_mapping.h"
#include "app/services/places/mission_map.h"
#include "app/services/recorded/review_cadence.h"
#include "app/services/review/reviewed_robot.h"
#include "app/services/review/reviewed_streams.h"
#include "core/event/motion_samples.h"
#include "core/event/scan_bodies.h"
#include "core/event/stream_role.h"
#include "core/mapping/placement/placement_format.h"
#include "core/mission/state/crop_state.h"
#include "core/mission/state/scan_state.h"
#include "core/perception/surroundings/virtual_scan.h"

namespace leitstand {
namespace {

/// How far back a robot's surroundings reach: the memory of a virtual scan.
const auto Preroll = std::chrono::nanoseconds(static_cast<std::int64_t>(VirtualScanSettings().memory * 1e9));
constexpr std::chrono::milliseconds CommandLife(500);  ///< of a drive command

/// The odometry's frame in the map from a moment on.
struct Anchor {
    Time from{};
    Pose odomInMap = Pose::Identity();
    bool certain = false;
    double certainty = 0.0;
    std::string how = {};
};

/// Returns the anchors by the key scans that @p robot made, or by where it was put, by ascending time.
std::vector<Anchor> anchorsOf(const RobotDescription& robot, const MissionState& state,
                              const ReviewIndex& index, Time at) {
    std::vector<Anchor> anchors;
    for (const auto& [id, scan] : *state.keyScans) {
        const auto points = index.keyScans.find(id);
        if (scan.entry.robot != robot.name || scan.pose.trust == ScanTrust::SetAside ||
            points == index.keyScans.end() || !points->second.scan->hasOdometry)
            continue;
        anchors.push_back({scan.entry.stamp,
                           scan.pose.scanInMap * points->second.scan->sensorInOdom.inverse(),
                           scan.pose.trust == ScanTrust::Certain, scan.pose.certainty,
                           logged(placement_format::NewestKeyScan)});
    }
    if (const auto places = index.places.find(robot.name); anchors.empty() && places != index.places.end()) {
        for (const RobotPlaceSample& place : places->second) {
            if (place.stamp > at) break;
            if (place.cause == RobotPlaceSample::Cause::Slot && !place.certain) {
                anchors.clear();  // looked for in vain: its place was unknown
                continue;
            }
            anchors.push_back({place.stamp, place.odomInMap, place.certain, place.certainty, place.how});
        }
    }
    std::stable_sort(anchors.begin(), anchors.end(),
                     [](const Anchor& a, const Anchor& b) { return a.from < b.from; });
    return anchors;
}

/// Returns the newest of @p anchors at @p at, else the first.
const Anchor& anchorAt(const std::vector<Anchor>& anchors, Time at) {
    const auto later = std::upper_bound(anchors.begin(), anchors.end(), at,
                                        [](Time time, const Anchor& one) { return time < one.from; });
    return later == anchors.begin() ? anchors.front() : *std::prev(later);
}

LiveMapPtr scansOf(const MissionState& state, const ReviewIndex& index, CroppedScans& cropped) {
    auto map = std::make_shared<LiveMap>();
    cropped.setCrop(cropOf(state).value_or(MapCrop{}));
    for (const auto& [id, kept] : *state.keyScans) {
        const auto found = index.keyScans.find(id);
        if (found == index.keyScans.end()) continue;  // its event cannot be read
        LiveKeyScan scan;
        scan.id = id;
        scan.scan = found->second.scan;
        scan.sensorInBase = kept.entry.sensorInBase;
        scan.pose = kept.pose;
        scan.matched = kept.entry.matched;
        scan.entered = kept.entry.stamp;
        const auto bodies = state.bodies->find(id);
        cropped.setBodies(id, bodies != state.bodies->end() ? bodies->second : std::vector<BodyInScan>());
        cropped.fit(scan);
        map->scans.push_back(std::move(scan));
    }
    return map;
}

}  // namespace

ReviewScene::ReviewScene(ReviewLog& log, const ReviewIndex& index) : m_log(log), m_index(index) {
    if (!log.robots().empty()) m_watched = log.robots().front().name;
}

const RobotDescription* ReviewScene::watched() const {
    const auto& robots = m_log.robots();
    const auto found =
        std::find_if(robots.begin(), robots.end(), [this](const auto& one) { return one.name == m_watched; });
    return found == robots.end() ? nullptr : &*found;
}

void ReviewScene::watch(const std::string& robot) {
    if (robot == m_watched) return;
    m_watched = robot;
    m_sight.reset();
    m_around.reset();
}

void ReviewScene::see(const Event& event) {
    if (event.robot == m_watched) return m_sight->onEvent(event, steadyOf(event.received));
    const auto* const scan = event.sample.as<KeyScanSample>();
    // A mission that was thinned, or recorded on a narrow link, has whole turns only.
    if (scan != nullptr && !m_scanned && scan->scan && scan->scan->robot == m_watched)
        m_sight->take(*scan, steadyOf(event.received));
}

void ReviewScene::beginSight(const RobotDescription& robot, Time from) {
    m_sight = std::make_unique<RobotSight>(robot);
    m_scanned = hasSlices(m_index, robot.name);
    for (const Event& event : m_index.fixed) see(event);
    // The newest sample before counts, however old it is.
    for (const StreamDescription& stream : robot.streams) {
        if (stream.role != StreamRole::Odometry && stream.role != StreamRole::Joints) continue;
        if (const auto before = m_log.newest(stream.topic, from)) see(*before);
    }
    m_seen = from;
}

void ReviewScene::look(Time at) {
    const RobotDescription* const robot = watched();
    if (robot == nullptr) return;
    const bool goesOn = m_sight && at >= m_seen && at - m_seen <= Preroll;
    if (!goesOn) beginSight(*robot, at - Preroll);
    m_log.events(m_seen, at, [this](const Event& event) { see(event); });
    m_seen = at;
    m_around = m_sight->view(steadyOf(at));
}

void ReviewScene::countStreams(const MissionState& state, Time at) {
    const RateWindow window = RateWindow::before(at, m_index);
    const MissionState earlier = m_log.stateAt(window.from);
    for (const RobotDescription& robot : m_log.robots())
        m_streams[robot.name] = reviewedStreams(robot, earlier, state, window, m_index);
}

void ReviewScene::showMap(const MissionState& state) {
    const auto cropIn = [](const MissionState& mission) { return mission.crop ? mission.crop->sequence : 0; };
    const bool same = m_map && &*m_mapped.keyScans == &*state.keyScans &&
                      &*m_mapped.bodies == &*state.bodies && cropIn(m_mapped) == cropIn(state);
    if (same) return;
    m_mapped = state;  // keeps the scans to compare with
    m_scans = scansOf(state, m_index, m_cropped);
    m_map = shownMap(*m_scans, m_map);
}

RobotInMap ReviewScene::place(const RobotDescription& robot, const MissionState& state, Time at) const {
    RobotInMap place;
    place.robot = robot.name;
    const auto reported = state.robots.find(robot.name);
    if (reported == state.robots.end() || !reported->second->odometry) return place;
    // The map may be that of the mission's end; what it has of later than now is of no use for the robot.
    const MissionState& map = m_which == ReviewMap::Finished ? *m_index.finished : state;
    const std::vector<Anchor> anchors = anchorsOf(robot, map, m_index, at);
    if (anchors.empty()) return place;
    const Anchor& now = anchorAt(anchors, at);
    const OdometrySample& odometry = reported->second->odometry->sample;
    place.placed = true;
    place.baseInMap = now.odomInMap * odometry.baseInOdom;
    place.stamp = odometry.header.stamp;
    place.certainty = now.certainty;
    place.certain = now.certain;
    place.how = now.how;
    constexpr double Apart = ReviewIndex::TrackApart;
    auto trail = std::make_shared<Trail>();
    if (const auto track = m_index.tracks.find(robot.name); track != m_index.tracks.end()) {
        for (const ReviewIndex::TrackPoint& point : track->second) {
            if (point.received > at) break;
            const Pose& odomInMap = anchorAt(anchors, point.received).odomInMap;
            const Eigen::Vector3f there = (odomInMap * point.baseInOdom.translation()).cast<float>();
            const float away = trail->empty() ? 0.0F : (there - trail->back().inMap).norm();
            trail->push_back({there, isGap(static_cast<double>(away), point.notReceived, Apart)});
        }
    }
    if (!trail->empty()) {
        const Eigen::Vector3d end = trail->back().inMap.cast<double>();
        place.afterGap = isGap((place.baseInMap.translation() - end).norm(), {}, Apart);
    }
    place.trail = std::move(trail);
    return place;
}

std::vector<Event> ReviewScene::pictures(Time at) {
    std::vector<Event> newest;
    const RobotDescription* const robot = watched();
    if (robot == nullptr) return newest;
    // Calibrations first: pictures are shown by them.
    for (const bool calibrations : {true, false}) {
        for (const StreamDescription& stream : robot->streams) {
            const bool picture = stream.role == StreamRole::Picture || stream.role == StreamRole::Thermal;
            if (calibrations ? stream.role != StreamRole::CameraInfo : !picture) continue;
            if (auto event = m_log.newest(stream.topic, at)) newest.push_back(std::move(*event));
        }
    }
    return newest;
}

ReviewMomentPtr ReviewScene::at(Time at, bool around) {
    auto moment = std::make_shared<ReviewMoment>();
    moment->now = at;
    const MissionState state = m_log.stateAt(at);
    moment->mission = std::make_shared<const MissionState>(state);
    if (around) countStreams(state, at);
    auto places = std::make_shared<RobotsInMap>();
    for (const RobotDescription& robot : m_log.robots()) {
        RobotView& view = moment->robots[robot.name] = reviewedRobot(robot, state, at);
        view.link.streams = m_streams[robot.name];
        places->push_back(place(robot, state, at));
    }
    moment->places = std::move(places);
    if (around) look(at);
    if (const RobotDescription* const robot = watched()) {
        RobotView& view = moment->robots[robot->name];
        view.around = m_around;
        if (m_sight) m_sight->fillView(view, steadyOf(at));
        if (const StreamDescription* const command = robot->stream(StreamRole::DriveCommand)) {
            const auto reported = m_log.newest(command->topic, at);
            const auto* const twist = reported ? reported->sample.as<TwistSample>() : nullptr;
            if (twist != nullptr && at - reported->received <= CommandLife)
                view.drive.velocity = {twist->linear.x(), twist->linear.y(), twist->angular.z()};
        }
    }
    showMap(m_which == ReviewMap::Finished ? *m_index.finished : state);
    moment->scans = m_scans;
    moment->map = m_map;
    moment->alarms = reviewedAlarms(state, at);
    moment->pictures = pictures(at);
    return moment;
}

}  // namespace leitstand
