#include "core/mapping/live/live_mapper.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "core/base/time.h"
#include "core/mapping/live/live_mapper_state.h"
#include "core/mapping/live/loops/free_space.h"
#include "core/mapping/live/scan_doubts.h"

namespace leitstand {
namespace {

constexpr double SamePlace = 0.1;                     ///< so near the local map is the same [m]
constexpr double CompareFrom = 0.8, CompareTo = 2.5;  ///< scans that tell of their scanner's ranges [m]
constexpr int MostAgain = 3;                          ///< comparisons with one scan, one after another
constexpr std::size_t WellCompared = 32;              ///< comparisons; from then on ...
constexpr std::size_t ComparedNext = 8;               ///< ... one key scan of so many is compared
constexpr std::chrono::seconds ClockStep(1);          ///< a station's clock that goes back farther was set

/// Whether @p live, which came to lie at @p found instead of at @p guess, was taken while something pushed or
/// held the robot: its points were put together by what odometry told of the motion within the turn.
bool wasPushed(const LiveScan& live, const Pose& guess, const Pose& found, const Step& step,
               const KeyScanRule& rule) {
    return step.trusted && live.end != TurnEnd::Sweep && live.way > rule.pushed &&
           distanceBetween(guess, found) > rule.pushed + rule.pushedOfWay * step.way;
}

}  // namespace

Pose LiveMapper::State::guessOf(const LiveScan& live, const RobotTrack& robot, Step& step) const {
    const Scan& scan = *live.scan;
    if (robot.placedInMap) return *robot.placedInMap * live.sensorInBase;
    const bool sameFrame = robot.odometryFrame < 0 || robot.odometryFrame == live.odometryFrame;
    if (!scan.hasOdometry || !robot.odometry || !sameFrame) return robot.sensorInMap;
    Pose moved = robot.sensorInOdom.inverse() * scan.sensorInOdom;
    moved.translation() *= robot.scale.factor();
    step.measured = robot.odometryFrame >= 0;
    step.trusted = step.measured && !live.isGuessed() && !robot.lost;
    const double way = std::max(live.way, moved.translation().norm());
    step.way = robot.way + way;
    step.openWay = robot.openWay + way;
    step.turn = robot.turn + std::max(live.turn, Eigen::AngleAxisd(moved.linear()).angle());
    const Pose guess = robot.sensorInMap * moved;
    step.moved = robot.moved + (guess.translation() - robot.sensorInMap.translation());
    return guess;
}

const LocalMap& LiveMapper::State::localAt(const Pose& place, const RobotTrack& robot) {
    if (!localStale && localKey == robot.key && distanceBetween(place, localPlace) <= SamePlace) return local;
    const bool put = robot.key == 0 || robot.placedInMap;
    if (put || robot.lost || !settings.loops.on) {
        local = localMap(ofPart(map.scans, put ? partAt(map.scans, place) : partOf(robot)), place,
                         settings.local);
    } else {
        const std::map<std::uint64_t, double> together = loops.sameAge(robot.key);
        std::vector<LiveKeyScan> scans;
        for (const LiveKeyScan& scan : map.scans) {
            if (together.contains(scan.id) && scan.counts()) scans.push_back(scan);
        }
        if (scans.empty()) scans = ofPart(map.scans, partOf(robot));
        local = localMap(scans, place, settings.local);
    }
    localPlace = place;
    localKey = robot.key;
    localStale = false;
    return local;
}

Match LiveMapper::State::matched(const LiveScan& live, const RobotTrack& robot, const PointCloud& cloud,
                                 const Pose& guess, const Step& step) {
    const auto up = live.levelKnown ? std::optional(upOf(live, robot)) : std::nullopt;
    Match result = match(cloud, localAt(guess, robot), guess, step, up, settings.match, settings.fit);
    if (result.doubts == 0 || robot.odometryFrame >= 0 || robot.placedInMap) return result;
    // The odometry may have begun anew while the station was away.
    Match second = match(cloud, localAt(robot.sensorInMap, robot), robot.sensorInMap, {}, up, settings.match,
                         settings.fit);
    return second.doubts == 0 ? second : result;
}

void LiveMapper::State::refine(const LiveScan& live, const RobotTrack& robot, const Pose& guess,
                               const Step& step, std::span<const PlacedBody> others, ReadyScan& ready,
                               Match& match) {
    // Where odometry erred from scan to scan it did within the turn, too.
    const TurnRefinementSettings& refinement = settings.refinement;
    const bool erred = step.trusted && live.end != TurnEnd::Sweep &&
                       (distanceBetween(guess, match.scanInMap) > refinement.from ||
                        angleBetween(guess, match.scanInMap) > refinement.fromAngle);
    const bool on = refinement.on || settings.refined.contains(live.scan->robot) || erred;
    if (!on || match.doubts != 0) return;
    const auto drift = turnDrift(cleaned(live, robot.body, match.scanInMap, preparing(robot, guess), others),
                                 localAt(guess, robot), match.scanInMap, settings.refinement);
    if (!drift) return;
    LiveScan straight = live;
    straight.scan = std::make_shared<const Scan>(straightened(*live.scan, *drift));
    ReadyScan second = readyScan(straight, robot.body, match.scanInMap, preparing(robot, guess), others);
    Match again = matched(straight, robot, second.reduced, guess, step);
    if (again.doubts != 0 || again.icp.overlap < match.icp.overlap) return;
    ready = std::move(second);
    match = again;
}

void LiveMapper::State::stand(const LiveScan& live, const RobotTrack& robot, const Pose& guess,
                              const Step& step, std::span<const PlacedBody> others, ReadyScan& ready,
                              Match& match) {
    const Scan& scan = *live.scan;
    const bool turns = scan.organised() && live.end != TurnEnd::Sweep && live.motionKnown;
    const bool fits = match.doubts == 0,
               asTold = fits && !wasPushed(live, guess, match.scanInMap, step, settings.keyScans);
    if (asTold || match.spun || !turns || !step.measured || live.isGuessed() ||
        step.moved.norm() <= settings.fit.jump)
        return;
    Eigen::Vector3d way(live.velocity.x(), live.velocity.y(), 0.0);
    way *= secondsBetween(scan.start, scan.end);
    TurnDrift drift;
    drift.whole.head<3>() = -(live.sensorInBase.linear().transpose() * way);
    LiveScan stood = live;
    stood.began.setZero();
    stood.scan = std::make_shared<const Scan>(straightened(scan, drift));
    Pose there = guess;
    there.translation() -= step.moved;
    Step turned = step;
    turned.trusted = true;
    turned.way = 0.0;
    turned.moved.setZero();
    ReadyScan second = readyScan(stood, robot.body, there, preparing(robot, there), others);
    Match found = matched(stood, robot, second.reduced, there, turned);
    if (found.doubts != 0 || found.icp.open > 0 || found.icp.overlap < settings.fit.spunOverlap) return;
    if (fits && (found.icp.overlap < match.icp.overlap || found.icp.rms >= match.icp.rms)) return;
    found.spun = true;
    ready = std::move(second);
    match = found;
}

bool LiveMapper::State::isHeldByOdometry(const LiveScan& live, const RobotTrack& robot,
                                         const ReadyScan& ready, const Pose& guess, const Step& step) {
    const bool followed = step.measured && !live.isGuessed() && !robot.contradicted;
    if (!followed || !canBegin(live, ready.reduced, settings.fit)) return false;
    const LocalMap& about = localAt(guess, robot);
    if (about.scans.empty()) return false;
    const KeyScanRule& rule = settings.keyScans;
    if (newGround(ready.reduced, about, guess, rule.newGroundFrom) < settings.fit.leastNew) return false;
    return std::none_of(about.scans.begin(), about.scans.end(), [&](std::uint64_t id) {
        const LiveKeyScan& other = *find(id);
        const Pose inOther = other.pose.scanInMap.inverse() * guess;
        return filledShare(*other.scan, *ready.scan, inOther) > settings.loops.mostFilled;
    });
}

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

Eigen::Vector3d LiveMapper::State::upOf(const LiveScan& live, const RobotTrack& robot) {
    return live.levelByUnit ? robot.lean.corrected(live.up, live.sensorInBase) : live.up;
}

void LiveMapper::State::lean(RobotTrack& robot, const LiveScan& live, const Match& match, double way) const {
    const bool goesOn = robot.known && !robot.placedInMap &&
                        angleBetween(robot.leanAt, robot.sensorInMap) < 1e-6 && way > 0.0;
    if (!goesOn) robot.lean.mapMoved();
    robot.lean.add(match.icp.pose, live.sensorInBase, live.up, way);
    robot.leanAt = match.scanInMap;
}

void LiveMapper::State::tellMount(RobotTrack& robot, const LiveScan& live, const Pose& scanInMap, bool fits) {
    // Scans that moved took the robot along.
    if (!fits || !robot.mountAt.isApprox(robot.sensorInMap, 1e-9)) robot.mount.breakOff();
    if (fits)
        robot.mount.add({scanInMap, live.scan->sensorInOdom, live.sensorInBase, live.velocity, live.yawRate});
    robot.mountAt = scanInMap;
}

void LiveMapper::State::calibrate(RobotTrack& robot, const LiveKeyScan& entered, const PointCloud& cloud) {
    if (has(entered.pose.doubts, ScanDoubt::Guessed)) return;
    // Some milliseconds each: what is known well enough is looked at now and then.
    const std::size_t before = robot.comparisons++;
    if (before >= WellCompared && before % ComparedNext != 0) return;
    const auto compares = [&](const LiveKeyScan& other) {
        // What an earlier run of the station made of its scans is not known.
        if (!other.counts() || other.odometryFrame < 0 || other.id <= robot.calibrated ||
            other.scan->robot != entered.scan->robot || has(other.pose.doubts, ScanDoubt::Guessed))
            return false;
        const double distance = distanceBetween(other.pose.scanInMap, entered.pose.scanInMap);
        return distance >= CompareFrom && distance <= CompareTo;
    };
    const auto other = std::find_if(map.scans.rbegin(), map.scans.rend(), compares);
    if (other == map.scans.rend()) return;
    robot.comparedAgain = robot.compared == other->id ? robot.comparedAgain + 1 : 0;
    robot.compared = other->id;
    if (robot.comparedAgain >= MostAgain) return;  // one that is bent is not to decide alone
    robot.rangeBias.add(cloud, other->reduced->unpacked(),
                        other->pose.scanInMap.inverse() * entered.pose.scanInMap);
}

ScannerCalibration LiveMapper::calibration(const std::string& name) const {
    const auto robot = m_state->robots.find(name);
    if (robot == m_state->robots.end()) return {};
    const RobotTrack& track = robot->second;
    return {track.rangeBias.estimate(), track.lean.lean(), track.lean.deviation(), track.mount.estimate()};
}

void LiveMapper::recalibrate(const std::string& name) {
    const auto robot = m_state->robots.find(name);
    if (robot == m_state->robots.end()) return;
    robot->second.rangeBias = {};
    robot->second.lean = {};
    robot->second.mount = {};
    robot->second.calibrated = m_state->nextId;  // the next one may be of a turn that was half over
    robot->second.comparisons = 0;
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
    m_state->localStale = true;
}

bool LiveMapper::leaveOut(std::uint64_t id, std::vector<BodyInScan> bodies) {
    LiveKeyScan* const scan = m_state->find(id);
    if (scan == nullptr) return false;
    const std::vector<BodyInScan> before = m_state->cropped.bodies(id);
    if (before == bodies) return false;
    // Also what the area hides now is in the map once that is wider.
    const ScanPtr whole = scan->kept ? scan->kept->whole() : scan->scan;
    const std::vector<bool> on = onOthers(whole->points, placed(bodies, Pose::Identity()), Pose::Identity());
    if (before.empty() && std::find(on.begin(), on.end(), true) == on.end()) return false;
    m_state->cropped.setBodies(id, std::move(bodies));
    m_state->cropped.fit(*scan, m_state->clouds);
    m_state->localStale = true;
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

MapUpdate LiveMapper::add(const LiveScan& live, Time now, std::span<const PlacedBody> others) {
    const auto start = std::chrono::steady_clock::now();
    State& state = *m_state;
    const Scan& scan = *live.scan;
    RobotTrack& robot = state.robots[scan.robot];
    MapUpdate update;
    Localisation& here = update.localisation;
    here.robot = scan.robot;
    here.stamp = scan.end;
    // A robot with several scanners: what one is off by is not told from what the other is.
    if (robot.known && !robot.sensorInBase.isApprox(live.sensorInBase, 1e-3)) recalibrate(scan.robot);
    const bool placed = robot.known || robot.placedInMap, empty = state.empty();
    const bool begins = state.beginsPart(robot);
    const bool first = empty || begins;  // of a part
    Step step;
    const Pose guess = begins   ? state.aside(live.up)
                       : placed ? state.guessOf(live, robot, step)
                                : levelled(Pose::Identity(), live.up, 1.0);
    if (!first && !placed) {
        here.trust = ScanTrust::Uncertain;
        here.doubts = static_cast<std::uint8_t>(ScanDoubt::Odometry);
        return update;
    }
    ReadyScan ready = readyScan(live, robot.body, guess, state.preparing(robot, guess), others);
    if (first && !canBegin(live, ready.reduced, state.settings.fit)) {
        here.trust = ScanTrust::Uncertain;
        here.doubts = static_cast<std::uint8_t>(ScanDoubt::Points);
        return update;
    }
    Match match;
    match.scanInMap = guess;
    double fresh = 1.0;
    std::uint64_t nearest = 0;
    std::vector<std::uint64_t> against;
    if (!first) {
        match = state.matched(live, robot, ready.reduced, guess, step);
        state.refine(live, robot, guess, step, others, ready, match);
        state.stand(live, robot, guess, step, others, ready, match);
        const LocalMap& local = state.localAt(match.scanInMap, robot);
        fresh = newGround(ready.reduced, local, match.scanInMap, state.settings.keyScans.newGroundFrom);
        against = local.scans;
        if (!local.scans.empty()) nearest = local.scans.front();
    }
    const bool held = match.doubts != 0 && state.isHeldByOdometry(live, robot, ready, guess, step);
    const bool lost = match.doubts != 0 && !held;
    if (lost && robot.beginsPart && !robot.placedInMap && canBegin(live, ready.reduced, state.settings.fit)) {
        robot.known = false;  // and so it begins
        return add(live, now, others);
    }
    here.doubts = lost ? match.doubts : std::uint8_t{0};
    here.trust = lost ? ScanTrust::Uncertain : ScanTrust::Certain;
    here.icp = match.icp;
    const Pose baseInSensor = live.sensorInBase.inverse();
    here.baseInMap = match.scanInMap * baseInSensor;
    here.guessInMap = guess * baseInSensor;
    here.odomInMap = match.scanInMap * scan.sensorInOdom.inverse();
    update.ready = ready.scan;
    update.scanInMap = match.scanInMap;
    // What a break left of a turn need not be enough, and says nothing then.
    if (match.doubts == static_cast<std::uint8_t>(ScanDoubt::Points) && live.end == TurnEnd::Break)
        return update;
    if (!first && match.doubts == 0 && live.levelByUnit) state.lean(robot, live, match, step.way);
    if (match.spun) {
        const Pose came = robot.sensorInMap.inverse() * match.scanInMap;
        robot.unspun = robot.unspun * robot.sensorInOdom * came * scan.sensorInOdom.inverse();
    }
    // The ground of scans that do not fit stays new.
    const bool stillLost = lost && robot.lost;
    // Also of a robot that stands the operator learns that it is lost; once, not whenever it is in doubt.
    const bool nowLost = lost && !robot.lost && !state.awaitsDecision(scan.robot);
    const bool pushed =
        match.doubts == 0 && wasPushed(live, guess, match.scanInMap, step, state.settings.keyScans);
    const bool wanted = state.enters(robot, match.scanInMap, stillLost ? 0.0 : fresh);
    robot.waited = wanted && pushed && !robot.waited && state.canWait(robot, match.scanInMap, fresh);
    if (first || !robot.known || nowLost || (wanted && !robot.waited)) {
        LiveKeyScan key;
        key.id = here.keyScan = state.nextId++;
        key.scan = keptOf(ready.scan);
        key.sensorInBase = live.sensorInBase;
        key.pose = {key.id,
                    match.scanInMap,
                    match.icp.rms,
                    match.icp.inlierRatio,
                    match.icp.overlap,
                    match.icp.certainty,
                    match.icp.converged,
                    here.trust,
                    match.doubts};
        if (live.extrapolated || live.bridged)
            key.pose.doubts |= static_cast<std::uint8_t>(ScanDoubt::Guessed);
        key.matched = nearest;
        key.part = begins ? key.id : state.partFor(robot, guess);
        key.enteredAt = match.scanInMap;
        key.entered = state.entering(now);
        if (live.levelKnown) key.up = state.upOf(live, robot);
        if (match.doubts == 0 && live.levelByUnit && !first)
            robot.lean.entered(match.icp.pose, match.scanInMap, live.up);
        key.odometryFrame = live.odometryFrame;
        key.unspun = robot.unspun;
        key.reduced = state.matchedOf(key, ready.reduced);
        state.cropped.fit(key, state.clouds);  // what was cropped before was seen from the guess
        update.keyScan =
            KeyScanSample{key.entered, key.id, ready.scan, key.sensorInBase, match.scanInMap, nearest};
        update.poses = ScanPosesSample{now, state.station, ScanPosesSample::Cause::Registration, {key.pose}};
        if (key.counts()) state.localStale = true;
        if (key.counts() && !first) state.calibrate(robot, key, ready.reduced);
        state.map.scans.push_back(std::move(key));
        if (state.settings.loops.on) state.link(update, robot, against, match, now);
        robot.keyInMap = match.scanInMap;
        robot.key = here.keyScan;
    }
    if (robot.known && step.trusted && match.doubts == 0 && match.icp.open == 0) {
        const double byWheels = distanceBetween(robot.sensorInOdom, scan.sensorInOdom);
        const double found = distanceBetween(robot.sensorInMap, match.scanInMap);
        if (!match.spun) robot.scale.add(byWheels, found);
        robot.wheels.add(byWheels, found);
    } else {
        robot.wheels.forget();
    }
    const bool comesByOdometry =
        step.trusted && live.motionKnown && !pushed && !match.spun && !robot.placedInMap;
    State::tellMount(robot, live, match.scanInMap,
                     comesByOdometry && match.doubts == 0 && match.icp.open == 0);
    robot.known = true;
    robot.beginsPart = robot.beginsPart && lost;
    robot.placedInMap.reset();
    robot.stamp = scan.end;
    robot.sensorInBase = live.sensorInBase;
    const double mayErr =
        state.settings.match.odometry.share * step.openWay / state.settings.fit.mostDeviation;
    robot.certainty = first  ? 1.0
                      : held ? std::max(0.1, 1.0 - mayErr)
                             : certaintyOf(match.icp.overlap, match.icp.certainty);
    robot.doubts = here.doubts;
    robot.sensorInMap = update.scanInMap;
    robot.sensorInOdom = scan.sensorInOdom;
    robot.odometryFrame = live.odometryFrame;
    robot.odometry = scan.hasOdometry;
    robot.lost = lost;
    // What has too few points tells of nothing, unless nobody knows how the robot came there.
    const bool blind = step.measured && has(match.doubts, ScanDoubt::Points);
    robot.contradicted = lost && (robot.contradicted || !blind);
    robot.way = robot.lost ? std::max(robot.way, step.way) : 0.0;
    robot.openWay = held || match.icp.open > 0 ? step.openWay : 0.0;
    robot.turn = robot.lost ? step.turn : 0.0;
    robot.moved = robot.lost ? step.moved : Eigen::Vector3d(Eigen::Vector3d::Zero());
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
