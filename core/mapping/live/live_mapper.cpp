#include "core/mapping/live/live_mapper.h"

#include <algorithm>
#include <chrono>
#include <utility>
#include <variant>

#include "core/base/time.h"
#include "core/mapping/live/live_mapper_state.h"
#include "core/mapping/live/scan_doubts.h"

namespace leitstand {
namespace {

constexpr std::chrono::seconds ClockStep(1);  ///< a station's clock that goes back farther was set

}  // namespace

bool LiveMapper::State::enters(const RobotTrack& robot, const Pose& scanInMap, double fresh) const {
    const KeyScanRule& rule = settings.keyScans;
    return distanceBetween(robot.keyInMap, scanInMap) >= rule.distance ||
           angleBetween(robot.keyInMap, scanInMap) >= rule.angle || fresh >= rule.newGround;
}

bool LiveMapper::State::canWait(const RobotTrack& robot, const Pose& scanInMap, double fresh) const {
    const KeyScanRule& rule = settings.keyScans;
    return distanceBetween(robot.keyInMap, scanInMap) < 2.0 * rule.distance &&
           angleBetween(robot.keyInMap, scanInMap) < rule.waitsWithin && fresh < rule.newGround;
}

ScannerCalibration LiveMapper::calibration(const std::string& name) const {
    const auto robot = m_state->robots.find(name);
    return robot != m_state->robots.end() ? robot->second.scanner.calibration() : ScannerCalibration{};
}

void LiveMapper::recalibrate(const std::string& name) {
    const auto robot = m_state->robots.find(name);
    // The next scan may be of a turn that had begun before.
    if (robot != m_state->robots.end()) robot->second.scanner.restart(m_state->nextId);
}

bool LiveMapper::State::empty() const {
    return std::none_of(map.scans.begin(), map.scans.end(),
                        [](const LiveKeyScan& scan) { return scan.counts(); });
}

bool LiveMapper::State::awaitsDecision(const std::string& robot) const {
    const auto newest = std::find_if(map.scans.rbegin(), map.scans.rend(), [&](const LiveKeyScan& scan) {
        return scan.scan->robot == robot && scan.pose.trust != ScanTrust::SetAside;
    });
    return newest != map.scans.rend() && newest->pose.trust == ScanTrust::Uncertain;
}

MatchedCloudPtr LiveMapper::State::matchedOf(LiveKeyScan& key, const PointCloud& reduced) const {
    key.kept = std::make_shared<KeptScan>(key.scan);
    return clouds.keep(
        reduced, [kept = key.kept, match = settings.match] { return reducedAgain(*kept->whole(), match); });
}

MatchedCloudPtr LiveMapper::State::promised(LiveKeyScan& key) const {
    key.kept = std::make_shared<KeptScan>(key.scan);
    return clouds.promise(
        [kept = key.kept, match = settings.match] { return reducedAgain(*kept->whole(), match); });
}

Time LiveMapper::State::entering(Time now) {
    const bool behind = now <= entered && entered - now < ClockStep;
    entered = behind ? entered + std::chrono::nanoseconds(1) : now;
    return entered;
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
    m_state->cropped.setCrop(crop);
    m_state->settings.crop = std::move(crop);
    for (LiveKeyScan& scan : m_state->map.scans) m_state->cropped.fit(scan, m_state->clouds);
    m_state->matcher.mapChanged();
}

bool LiveMapper::leaveOut(std::uint64_t id, std::vector<BodyInScan> bodies) {
    LiveKeyScan* const scan = m_state->find(id);
    if (scan == nullptr) return false;
    const std::vector<BodyInScan> before = m_state->cropped.bodies(id);
    if (before == bodies) return false;
    // Points that the area hides now return to the map once it is wider.
    const ScanPtr whole = scan->kept ? scan->kept->whole() : scan->scan;
    const std::vector<bool> on = onOthers(whole->points, placed(bodies, Pose::Identity()), Pose::Identity());
    if (before.empty() && std::find(on.begin(), on.end(), true) == on.end()) return false;
    m_state->cropped.setBodies(id, std::move(bodies));
    m_state->cropped.fit(*scan, m_state->clouds);
    m_state->matcher.mapChanged();
    return true;
}

std::vector<BodyInScan> LiveMapper::bodiesIn(std::uint64_t id) const {
    return m_state->cropped.bodies(id);
}

void LiveMapper::place(const std::string& robot, const Pose& baseInMap) {
    m_state->robots[robot].placedInMap = baseInMap;
    m_state->robots[robot].beginsPart = false;
}

void LiveMapper::beginPart(const std::string& robot) {
    m_state->robots[robot].beginsPart = true;
}

bool LiveMapper::isAstray(const std::string& name) const {
    const auto found = m_state->robots.find(name);
    if (found == m_state->robots.end()) return false;
    const RobotTrack& robot = found->second;
    if (!robot.known || !robot.lost || robot.placedInMap) return false;
    return !robot.odometry ||
           m_state->settings.match.odometry.share * robot.way > m_state->settings.fit.mostDeviation;
}

Pose LiveMapper::State::aside(const Eigen::Vector3d& up) const {
    Pose pose = levelled(Pose::Identity(), up, 1.0);
    pose.translation() = map.scans.front().pose.scanInMap.translation();
    for (const LiveKeyScan& scan : map.scans)
        pose.translation().y() = std::min(pose.translation().y(), scan.pose.scanInMap.translation().y());
    pose.translation().y() -= settings.loops.partsApart;
    return pose;
}

std::variant<LiveMapper::State::Registered, ScanDoubt> LiveMapper::State::registered(
    const LiveScan& live, const RobotTrack& robot, std::span<const PlacedBody> others) {
    const bool placed = robot.known || robot.placedInMap;
    Registered found;
    found.begins = beginsPart(robot);
    found.first = empty() || found.begins;
    if (!found.first && !placed) return ScanDoubt::Odometry;
    if (found.begins) {
        found.guess = aside(live.up);
    } else if (placed) {
        const ExpectedScan expected = expectedAt(live, robot);
        found.guess = expected.scanInMap;
        found.step = expected.step;
    } else {
        found.guess = levelled(Pose::Identity(), live.up, 1.0);
    }
    const LiveSettings& preparation = preparing(robot, found.guess);
    found.ready = readyScan(live, robot.body, found.guess, preparation, others);
    found.match.scanInMap = found.guess;
    if (found.first) {
        if (!canBegin(live, found.ready.reduced, settings.fit)) return ScanDoubt::Points;
        return found;
    }
    const ScanToMatch scan{live, robot, found.guess, found.step, others, preparation};
    found.match = matcher.match(scan, found.ready);
    const LocalMap& local = matcher.localAt(found.match.scanInMap, robot);
    found.fresh =
        newGround(found.ready.reduced, local, found.match.scanInMap, settings.keyScans.newGroundFrom);
    found.against = local.scans;
    const bool fits = found.match.doubts == 0;
    found.held = !fits && matcher.isHeldByOdometry(scan, found.ready);
    found.lost = !fits && !found.held;
    found.pushed = fits && wasPushed(live, found.guess, found.match.scanInMap, found.step, settings.keyScans);
    return found;
}

bool LiveMapper::State::isKeyScan(RobotTrack& robot, const LiveScan& live, const Registered& found) const {
    const Pose& scanInMap = found.match.scanInMap;
    // The ground of scans that do not fit stays new.
    const bool stillLost = found.lost && robot.lost;
    // The operator also learns that a standing robot is lost, but once, not at every doubt.
    const bool nowLost = found.lost && !robot.lost && !awaitsDecision(live.scan->robot);
    const bool wanted = enters(robot, scanInMap, stillLost ? 0.0 : found.fresh);
    robot.waited = wanted && found.pushed && !robot.waited && canWait(robot, scanInMap, found.fresh);
    return found.first || !robot.known || nowLost || (wanted && !robot.waited);
}

void LiveMapper::State::enter(MapUpdate& update, RobotTrack& robot, const LiveScan& live,
                              const Registered& found, Time now) {
    const Match& match = found.match;
    const std::uint64_t nearest = found.against.empty() ? 0 : found.against.front();
    LiveKeyScan key;
    key.id = update.localisation.keyScan = nextId++;
    key.scan = keptOf(found.ready.scan);
    key.sensorInBase = live.sensorInBase;
    key.pose = {key.id,
                match.scanInMap,
                match.icp.rms,
                match.icp.inlierRatio,
                match.icp.overlap,
                match.icp.certainty,
                match.icp.converged,
                update.localisation.trust,
                match.doubts};
    if (live.extrapolated || live.bridged) key.pose.doubts |= static_cast<std::uint8_t>(ScanDoubt::Guessed);
    key.matched = nearest;
    key.part = found.begins ? key.id : partFor(robot, found.guess);
    key.enteredAt = match.scanInMap;
    key.entered = entering(now);
    if (live.levelKnown) key.up = robot.scanner.upOf(live);
    if (match.doubts == 0 && live.levelByUnit && !found.first) robot.scanner.enteredMap(live, match);
    key.odometryFrame = live.odometryFrame;
    key.unspun = robot.unspun;
    key.reduced = matchedOf(key, found.ready.reduced);
    cropped.fit(key, clouds);  // until here it is cropped as seen from the guess
    update.keyScan =
        KeyScanSample{key.entered, key.id, found.ready.scan, key.sensorInBase, match.scanInMap, nearest};
    update.poses = ScanPosesSample{now, station, ScanPosesSample::Cause::Registration, {key.pose}};
    if (key.counts()) matcher.mapChanged();
    if (key.counts() && !found.first) robot.scanner.compare(key, found.ready.reduced, map);
    map.scans.push_back(std::move(key));
    if (settings.loops.on) link(update, robot, found.against, match, now);
    robot.keyInMap = match.scanInMap;
    robot.key = update.localisation.keyScan;
}

void LiveMapper::State::advance(RobotTrack& robot, const LiveScan& live, const Registered& found) const {
    const Scan& scan = *live.scan;
    const Match& match = found.match;
    const Step& step = found.step;
    const bool bySurfaces = match.doubts == 0 && match.icp.open == 0;  // in all directions
    if (robot.known && step.trusted && bySurfaces) {
        const double byWheels = distanceBetween(robot.sensorInOdom, scan.sensorInOdom);
        const double way = distanceBetween(robot.sensorInMap, match.scanInMap);
        if (!match.spun) robot.scale.add(byWheels, way);
        robot.wheels.add(byWheels, way);
    } else {
        robot.wheels.forget();
    }
    const bool comesByOdometry =
        step.trusted && live.motionKnown && !found.pushed && !match.spun && !robot.placedInMap;
    robot.scanner.addMount(live, match.scanInMap, robot.sensorInMap, comesByOdometry && bySurfaces);
    robot.known = true;
    robot.beginsPart = robot.beginsPart && found.lost;
    robot.placedInMap.reset();
    robot.stamp = scan.end;
    robot.sensorInBase = live.sensorInBase;
    const double mayErr = settings.match.odometry.share * step.openWay / settings.fit.mostDeviation;
    robot.certainty = found.first  ? 1.0
                      : found.held ? std::max(0.1, 1.0 - mayErr)
                                   : certaintyOf(match.icp.overlap, match.icp.certainty);
    robot.doubts = found.lost ? match.doubts : std::uint8_t{0};
    robot.sensorInMap = match.scanInMap;
    robot.sensorInOdom = scan.sensorInOdom;
    robot.odometryFrame = live.odometryFrame;
    robot.odometry = scan.hasOdometry;
    robot.lost = found.lost;
    // A scan with too few points contradicts nothing, unless it is unknown how the robot came there.
    const bool blind = step.measured && has(match.doubts, ScanDoubt::Points);
    robot.contradicted = found.lost && (robot.contradicted || !blind);
    robot.way = robot.lost ? std::max(robot.way, step.way) : 0.0;
    robot.openWay = found.held || match.icp.open > 0 ? step.openWay : 0.0;
    robot.turn = robot.lost ? step.turn : 0.0;
    robot.moved = robot.lost ? step.moved : Eigen::Vector3d(Eigen::Vector3d::Zero());
}

MapUpdate LiveMapper::add(const LiveScan& live, Time now, std::span<const PlacedBody> others) {
    const auto start = std::chrono::steady_clock::now();
    State& state = *m_state;
    const Scan& scan = *live.scan;
    RobotTrack& robot = state.robots[scan.robot];
    MapUpdate update;
    Localisation& here = update.localisation;
    here.robot = scan.robot;
    here.stamp = scan.end;
    // With several scanners, the error of one is not separated from that of another.
    if (robot.known && !robot.sensorInBase.isApprox(live.sensorInBase, 1e-3)) recalibrate(scan.robot);
    const auto result = state.registered(live, robot, others);
    if (const auto* doubt = std::get_if<ScanDoubt>(&result)) {
        here.trust = ScanTrust::Uncertain;
        here.doubts = static_cast<std::uint8_t>(*doubt);
        return update;
    }
    const auto& found = std::get<State::Registered>(result);
    const Match& match = found.match;
    if (found.lost && robot.beginsPart && !robot.placedInMap &&
        canBegin(live, found.ready.reduced, state.settings.fit)) {
        robot.known = false;  // and so it begins a part
        return add(live, now, others);
    }
    here.doubts = found.lost ? match.doubts : std::uint8_t{0};
    here.trust = found.lost ? ScanTrust::Uncertain : ScanTrust::Certain;
    here.icp = match.icp;
    const Pose baseInSensor = live.sensorInBase.inverse();
    here.baseInMap = match.scanInMap * baseInSensor;
    here.guessInMap = found.guess * baseInSensor;
    here.odomInMap = match.scanInMap * scan.sensorInOdom.inverse();
    update.ready = found.ready.scan;
    update.scanInMap = match.scanInMap;
    // The rest of a broken turn may have too few points. Then it holds no information.
    if (match.doubts == static_cast<std::uint8_t>(ScanDoubt::Points) && live.end == TurnEnd::Break)
        return update;
    if (!found.first && match.doubts == 0 && live.levelByUnit) {
        const bool goesOn = robot.known && !robot.placedInMap;
        robot.scanner.addLean(live, match, goesOn ? &robot.sensorInMap : nullptr, found.step.way);
    }
    if (match.spun) {
        const Pose came = robot.sensorInMap.inverse() * match.scanInMap;
        robot.unspun = robot.unspun * robot.sensorInOdom * came * scan.sensorInOdom.inverse();
    }
    if (state.isKeyScan(robot, live, found)) state.enter(update, robot, live, found, now);
    state.advance(robot, live, found);
    here.seconds = toSeconds(std::chrono::steady_clock::now() - start);
    return update;
}

std::optional<RobotFix> LiveMapper::fix(const std::string& name) const {
    const auto robot = m_state->robots.find(name);
    if (robot == m_state->robots.end() || !robot->second.known) return std::nullopt;
    const RobotTrack& track = robot->second;
    if (track.placedInMap)
        return RobotFix{track.stamp, *track.placedInMap, 0.0, static_cast<std::uint8_t>(ScanDoubt::Odometry)};
    return RobotFix{track.stamp,        track.sensorInMap * track.sensorInBase.inverse(),
                    track.certainty,    track.doubts,
                    track.wheels.way(), m_state->partOf(track)};
}

LiveMapPtr LiveMapper::map() const {
    return std::make_shared<const LiveMap>(m_state->map);
}

}  // namespace leitstand
