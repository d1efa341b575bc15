#include "core/mapping/live/registration/scan_registration.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "core/mapping/live/scan_doubts.h"

namespace leitstand {

bool ScanRegistration::enters(const RobotTrack& robot, const Pose& scanInMap, double fresh) const {
    const KeyScanRule& rule = m_map.settings.keyScans;
    return distanceBetween(robot.keyInMap, scanInMap) >= rule.distance ||
           angleBetween(robot.keyInMap, scanInMap) >= rule.angle || fresh >= rule.newGround;
}

bool ScanRegistration::canWait(const RobotTrack& robot, const Pose& scanInMap, double fresh) const {
    const KeyScanRule& rule = m_map.settings.keyScans;
    return distanceBetween(robot.keyInMap, scanInMap) < 2.0 * rule.distance &&
           angleBetween(robot.keyInMap, scanInMap) < rule.waitsWithin && fresh < rule.newGround;
}

Pose ScanRegistration::aside(const Eigen::Vector3d& up) const {
    Pose pose = levelled(Pose::Identity(), up, 1.0);
    pose.translation() = m_map.map.scans.front().pose.scanInMap.translation();
    for (const LiveKeyScan& scan : m_map.map.scans)
        pose.translation().y() = std::min(pose.translation().y(), scan.pose.scanInMap.translation().y());
    pose.translation().y() -= m_map.settings.loops.partsApart;
    return pose;
}

bool ScanRegistration::isAlone(const RobotTrack& robot) {
    if (robot.placedInMap || robot.key == 0) return false;
    const std::uint64_t part = m_map.partOf(robot);
    return std::none_of(m_map.map.scans.begin(), m_map.map.scans.end(),
                        [part](const LiveKeyScan& scan) { return scan.counts() && scan.part == part; });
}

bool ScanRegistration::beginsPart(const RobotTrack& robot) {
    if (m_map.empty()) return false;
    return robot.known || robot.placedInMap ? isAlone(robot) : robot.beginsPart;
}

std::uint64_t ScanRegistration::partFor(const RobotTrack& robot, const Pose& guess) {
    return robot.placedInMap || robot.key == 0 ? partAt(m_map.map.scans, guess) : m_map.partOf(robot);
}

const LiveSettings& ScanRegistration::preparing(const RobotTrack& robot, const Pose& guess) {
    return beginsPart(robot) || partFor(robot, guess) != 0 ? m_map.uncropped : m_map.settings;
}

std::variant<ScanRegistration::Registered, ScanDoubt> ScanRegistration::registered(
    const LiveScan& live, const RobotTrack& robot, std::span<const PlacedBody> others) {
    const bool placed = robot.known || robot.placedInMap;
    Registered found;
    found.begins = beginsPart(robot);
    found.first = m_map.empty() || found.begins;
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
        if (!canBegin(live, found.ready.reduced, m_map.settings.fit)) return ScanDoubt::Points;
        return found;
    }
    const ScanToMatch scan{live, robot, found.guess, found.step, others, preparation};
    found.match = m_map.matcher.match(scan, found.ready);
    const LocalMap& local = m_map.matcher.localAt(found.match.scanInMap, robot);
    found.fresh =
        newGround(found.ready.reduced, local, found.match.scanInMap, m_map.settings.keyScans.newGroundFrom);
    found.against = local.scans;
    const bool fits = found.match.doubts == 0;
    found.held = !fits && m_map.matcher.isHeldByOdometry(scan, found.ready);
    found.lost = !fits && !found.held;
    found.pushed =
        fits && wasPushed(live, found.guess, found.match.scanInMap, found.step, m_map.settings.keyScans);
    return found;
}

bool ScanRegistration::isKeyScan(RobotTrack& robot, const LiveScan& live, const Registered& found) const {
    const Pose& scanInMap = found.match.scanInMap;
    // The ground of scans that do not fit stays new.
    const bool stillLost = found.lost && robot.lost;
    // The operator also learns that a standing robot is lost, but once, not at every doubt.
    const bool nowLost = found.lost && !robot.lost && !m_map.awaitsDecision(live.scan->robot);
    const bool wanted = enters(robot, scanInMap, stillLost ? 0.0 : found.fresh);
    robot.waited = wanted && found.pushed && !robot.waited && canWait(robot, scanInMap, found.fresh);
    return found.first || !robot.known || nowLost || (wanted && !robot.waited);
}

void ScanRegistration::enter(MapUpdate& update, RobotTrack& robot, const LiveScan& live,
                             const Registered& found, Time now) {
    const Match& match = found.match;
    const std::uint64_t nearest = found.against.empty() ? 0 : found.against.front();
    LiveKeyScan key;
    key.id = update.localisation.keyScan = m_map.nextId++;
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
    key.entered = m_map.entering(now);
    if (live.levelKnown) key.up = robot.scanner.upOf(live);
    if (match.doubts == 0 && live.levelByUnit && !found.first && !live.plane)
        robot.scanner.enteredMap(live, match);
    key.odometryFrame = live.odometryFrame;
    key.unspun = robot.unspun;
    key.reduced = m_map.matchedOf(key, found.ready.reduced);
    m_map.cropped.fit(key, m_map.clouds);  // until here it is cropped as seen from the guess
    update.keyScan =
        KeyScanSample{key.entered, key.id, found.ready.scan, key.sensorInBase, match.scanInMap, nearest};
    update.poses = ScanPosesSample{now, m_map.station, ScanPosesSample::Cause::Registration, {key.pose}};
    if (key.counts()) m_map.matcher.mapChanged();
    if (key.counts() && !found.first && !live.plane)
        robot.scanner.compare(key, found.ready.reduced, m_map.map);
    m_map.map.scans.push_back(std::move(key));
    if (m_map.settings.loops.on) link(update, robot, found.against, match, now);
    robot.keyInMap = match.scanInMap;
    robot.key = update.localisation.keyScan;
}

void ScanRegistration::advance(RobotTrack& robot, const LiveScan& live, const Registered& found) const {
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
    // A plane laser's walls and floor are assumed, and show no fault of it.
    if (!live.plane)
        robot.scanner.addMount(live, match.scanInMap, robot.sensorInMap, comesByOdometry && bySurfaces);
    robot.known = true;
    robot.beginsPart = robot.beginsPart && found.lost;
    robot.placedInMap.reset();
    robot.stamp = scan.end;
    robot.sensorInBase = live.sensorInBase;
    const double mayErr =
        m_map.settings.match.odometry.share * step.openWay / m_map.settings.fit.mostDeviation;
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

void ScanRegistration::link(MapUpdate& update, const RobotTrack& robot,
                            std::span<const std::uint64_t> against, const Match& match, Time now) {
    const LiveKeyScan& key = m_map.map.scans.back();
    std::vector<LiveKeyScan> others;
    for (const std::uint64_t id : against) {
        if (const LiveKeyScan* const other = m_map.find(id)) others.push_back(*other);
    }
    // A robot that was placed may have been carried, which its odometry does not know. A scan that begins a
    // part is connected with nothing.
    const bool apart = robot.key == 0 || robot.placedInMap || key.part == key.id;
    const LiveKeyScan* before = apart ? nullptr : m_map.find(robot.key);
    // A scan that odometry alone holds must not depend on a scan that may be rejected.
    if (before != nullptr && !before->counts() && key.counts() && match.doubts != 0) {
        const auto counts =
            std::find_if(m_map.map.scans.rbegin(), m_map.map.scans.rend(), [&](const LiveKeyScan& one) {
                return one.counts() && one.id != key.id && one.scan->robot == key.scan->robot &&
                       one.odometryFrame == key.odometryFrame;
            });
        if (counts != m_map.map.scans.rend()) before = &*counts;
    }
    std::vector<Link> links = m_map.graph.add({key, before, others, match});
    if (!links.empty()) update.links = ScanLinksSample{now, m_map.station, std::move(links)};
    if (!key.counts()) return;
    std::vector<Link> loop = m_map.loops.close(key, m_map.map);
    if (loop.empty()) {
        if (m_map.loops.seeks(key, m_map.map)) m_map.sought = key.id;
        return;
    }
    m_map.unsolved = m_map.unsolved || loop.front().active;
    update.loop = ScanLinksSample{now, m_map.station, std::move(loop)};
}

MapUpdate ScanRegistration::add(const LiveScan& live, Time now, std::span<const PlacedBody> others) {
    const auto start = std::chrono::steady_clock::now();
    const Scan& scan = *live.scan;
    RobotTrack& robot = m_map.robots[scan.robot];
    MapUpdate update;
    Localisation& here = update.localisation;
    here.robot = scan.robot;
    here.stamp = scan.end;
    // With several scanners, the error of one is not separated from that of another.
    if (robot.known && !robot.sensorInBase.isApprox(live.sensorInBase, 1e-3))
        robot.scanner.restart(m_map.nextId);
    const auto result = registered(live, robot, others);
    if (const auto* doubt = std::get_if<ScanDoubt>(&result)) {
        here.trust = ScanTrust::Uncertain;
        here.doubts = static_cast<std::uint8_t>(*doubt);
        return update;
    }
    const auto& found = std::get<Registered>(result);
    const Match& match = found.match;
    if (found.lost && robot.beginsPart && !robot.placedInMap &&
        canBegin(live, found.ready.reduced, m_map.settings.fit)) {
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
    if (!found.first && match.doubts == 0 && live.levelByUnit && !live.plane) {
        const bool goesOn = robot.known && !robot.placedInMap;
        robot.scanner.addLean(live, match, goesOn ? &robot.sensorInMap : nullptr, found.step.way);
    }
    if (match.spun) {
        const Pose came = robot.sensorInMap.inverse() * match.scanInMap;
        robot.unspun = robot.unspun * robot.sensorInOdom * came * scan.sensorInOdom.inverse();
    }
    if (isKeyScan(robot, live, found)) enter(update, robot, live, found, now);
    advance(robot, live, found);
    here.seconds = toSeconds(std::chrono::steady_clock::now() - start);
    return update;
}

}  // namespace leitstand
