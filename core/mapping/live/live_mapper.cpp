#include "core/mapping/live/live_mapper.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "core/mapping/live/local_map.h"
#include "core/mapping/live/scan_work.h"

namespace leitstand {
namespace {

/// What is known of a robot's way.
struct RobotTrack {
    RobotBody body;
    bool placed = false;
    Pose sensorInMap = Pose::Identity();  ///< at the newest scan
    Pose sensorInOdom = Pose::Identity();
    int odometryFrame = -1;
    bool odometry = false;              ///< whether sensorInOdom was measured
    Pose keyInOdom = Pose::Identity();  ///< sensorInOdom of the newest key scan
    Pose keyInMap = Pose::Identity();
    int scans = 0;
};

}  // namespace

struct LiveMapper::State {
    State(std::string name, LiveSettings chosen) : station(std::move(name)), settings(std::move(chosen)) {}

    [[nodiscard]] Pose guessOf(const LiveScan& live, const RobotTrack& robot, Step& step) const;
    [[nodiscard]] const LocalMap& localAt(const Pose& place);
    [[nodiscard]] bool enters(const RobotTrack& robot, const Pose& scanInMap, double fresh) const;

    std::string station;
    LiveSettings settings;
    std::map<std::string, RobotTrack> robots;
    LiveMap map;
    std::uint64_t nextId = 1;
    LocalMap local;
    Pose localPlace = Pose::Identity();
    bool localStale = true;
};

Pose LiveMapper::State::guessOf(const LiveScan& live, const RobotTrack& robot, Step& step) const {
    const Scan& scan = *live.scan;
    step.known =
        scan.hasOdometry && robot.odometry && live.odometryFrame == robot.odometryFrame && !live.bridged;
    if (!scan.hasOdometry || !robot.odometry || live.odometryFrame != robot.odometryFrame)
        return robot.sensorInMap;
    const Pose moved = robot.sensorInOdom.inverse() * scan.sensorInOdom;
    step.way = moved.translation().norm();
    step.turn = Eigen::AngleAxisd(moved.linear()).angle();
    return robot.sensorInMap * moved;
}

const LocalMap& LiveMapper::State::localAt(const Pose& place) {
    if (localStale || distanceBetween(place, localPlace) > 0.1) {
        local = localMap(map.scans, place, settings.local);
        localPlace = place;
        localStale = false;
    }
    return local;
}

bool LiveMapper::State::enters(const RobotTrack& robot, const Pose& scanInMap, double fresh) const {
    const KeyScanRule& rule = settings.keyScans;
    return distanceBetween(robot.keyInMap, scanInMap) >= rule.distance ||
           angleBetween(robot.keyInMap, scanInMap) >= rule.angle || fresh >= rule.newGround;
}

LiveMapper::LiveMapper(std::string station, LiveSettings settings)
    : m_state(std::make_unique<State>(std::move(station), std::move(settings))) {}
LiveMapper::~LiveMapper() = default;
LiveMapper::LiveMapper(LiveMapper&&) noexcept = default;
LiveMapper& LiveMapper::operator=(LiveMapper&&) noexcept = default;

void LiveMapper::setBody(const std::string& robot, RobotBody body) {
    m_state->robots[robot].body = std::move(body);
}

void LiveMapper::setCrop(MapCrop crop) {
    m_state->settings.crop = std::move(crop);
}

MapUpdate LiveMapper::add(const LiveScan& live, Time now) {
    const auto start = std::chrono::steady_clock::now();
    State& state = *m_state;
    const Scan& scan = *live.scan;
    RobotTrack& robot = state.robots[scan.robot];
    const bool first = state.map.scans.empty();
    Step step;
    Pose guess = Pose::Identity();
    if (first) {
        guess = levelled(guess, live.up, 1.0);
    } else {
        guess = state.guessOf(live, robot, step);
    }
    ReadyScan ready = readyScan(live, robot.body, guess, state.settings);
    MapUpdate update;
    Localisation& here = update.localisation.emplace();
    Match matched;
    matched.scanInMap = guess;
    double fresh = 1.0;
    std::uint64_t nearest = 0;
    if (!first) {
        const LocalMap& local = state.localAt(guess);
        matched = match(ready.reduced, local, guess, step,
                        live.levelKnown ? std::optional(live.up) : std::nullopt, state.settings);
        fresh = newGround(ready.reduced, local, matched.scanInMap, state.settings.keyScans.newGroundFrom);
        if (!local.scans.empty()) nearest = local.scans.front();
    }
    here.robot = scan.robot;
    here.stamp = scan.end;
    here.doubts = matched.doubts;
    here.trust = matched.doubts == 0 ? ScanTrust::Certain : ScanTrust::Uncertain;
    here.icp = matched.icp;
    const Pose baseInSensor = live.sensorInBase.inverse();
    here.baseInMap = matched.scanInMap * baseInSensor;
    here.guessInMap = guess * baseInSensor;
    here.odomInMap = matched.scanInMap * scan.sensorInOdom.inverse();
    if (first || state.enters(robot, matched.scanInMap, fresh)) {
        LiveKeyScan key;
        key.id = here.keyScan = state.nextId++;
        key.scan = ready.scan;
        key.sensorInBase = live.sensorInBase;
        key.pose = {key.id,
                    matched.scanInMap,
                    matched.icp.rms,
                    matched.icp.inlierRatio,
                    matched.icp.overlap,
                    matched.icp.certainty,
                    matched.icp.converged,
                    here.trust,
                    here.doubts};
        key.matched = nearest;
        key.odometryFrame = live.odometryFrame;
        key.reduced = std::make_shared<const PointCloud>(std::move(ready.reduced));
        update.keyScan = KeyScanSample{now, key.id, key.scan, key.sensorInBase, matched.scanInMap, nearest};
        update.poses = ScanPosesSample{now, state.station, ScanPosesSample::Cause::Registration, {key.pose}};
        if (key.counts()) state.localStale = true;
        state.map.scans.push_back(std::move(key));
        robot.keyInMap = matched.scanInMap;
    }
    robot.sensorInMap = matched.scanInMap;
    robot.sensorInOdom = scan.sensorInOdom;
    robot.odometryFrame = live.odometryFrame;
    robot.odometry = scan.hasOdometry;
    here.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return update;
}

LiveMapPtr LiveMapper::map() const {
    return std::make_shared<const LiveMap>(m_state->map);
}

}  // namespace leitstand
