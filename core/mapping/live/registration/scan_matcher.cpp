#include "core/mapping/live/registration/scan_matcher.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "core/base/time.h"
#include "core/mapping/live/loops/places/free_space.h"

namespace leitstand {
namespace {

constexpr double SamePlace = 0.1;  ///< the local map is kept while the place is so near [m]

}  // namespace

ExpectedScan expectedAt(const LiveScan& live, const RobotTrack& robot) {
    const Scan& scan = *live.scan;
    if (robot.placedInMap) return {*robot.placedInMap * live.sensorInBase, {}};
    const bool sameFrame = robot.odometryFrame < 0 || robot.odometryFrame == live.odometryFrame;
    if (!scan.hasOdometry || !robot.odometry || !sameFrame) return {robot.sensorInMap, {}};
    Pose moved = robot.sensorInOdom.inverse() * scan.sensorInOdom;
    moved.translation() *= robot.scale.factor();
    Step step;
    step.measured = robot.odometryFrame >= 0;
    step.trusted = step.measured && !live.isGuessed() && !robot.lost;
    const double way = std::max(live.way, moved.translation().norm());
    step.way = robot.way + way;
    step.openWay = robot.openWay + way;
    step.turn = robot.turn + std::max(live.turn, Eigen::AngleAxisd(moved.linear()).angle());
    const Pose guess = robot.sensorInMap * moved;
    step.moved = robot.moved + (guess.translation() - robot.sensorInMap.translation());
    return {guess, step};
}

bool wasPushed(const LiveScan& live, const Pose& guess, const Pose& found, const Step& step,
               const KeyScanRule& rule) {
    return step.trusted && live.end != TurnEnd::Sweep && live.way > rule.pushed &&
           distanceBetween(guess, found) > rule.pushed + rule.pushedOfWay * step.way;
}

const LocalMap& ScanMatcher::localAt(const Pose& place, const RobotTrack& robot) {
    if (!m_stale && m_key == robot.key && distanceBetween(place, m_place) <= SamePlace) return m_local;
    const bool put = robot.key == 0 || robot.placedInMap;
    if (put || robot.lost || !m_settings.loops.on) {
        m_local = localMap(ofPart(m_map.scans, put ? partAt(m_map.scans, place) : partOf(robot)), place,
                           m_settings.local);
    } else {
        const std::map<std::uint64_t, double> together = m_graph.sameAge(robot.key);
        std::vector<LiveKeyScan> scans;
        for (const LiveKeyScan& scan : m_map.scans) {
            if (together.contains(scan.id) && scan.counts()) scans.push_back(scan);
        }
        if (scans.empty()) scans = ofPart(m_map.scans, partOf(robot));
        m_local = localMap(scans, place, m_settings.local);
    }
    m_place = place;
    m_key = robot.key;
    m_stale = false;
    return m_local;
}

Match ScanMatcher::match(const ScanToMatch& scan, ReadyScan& ready) {
    Match found = matched(scan, ready.reduced);
    refine(scan, ready, found);
    stand(scan, ready, found);
    return found;
}

Match ScanMatcher::matched(const ScanToMatch& scan, const PointCloud& cloud) {
    const LiveScan& live = scan.live;
    const RobotTrack& robot = scan.robot;
    const auto up = live.levelKnown ? std::optional(robot.scanner.upOf(live)) : std::nullopt;
    Match result = leitstand::match(cloud, localAt(scan.guess, robot), scan.guess, scan.step, up,
                                    m_settings.match, m_settings.fit);
    if (result.doubts == 0 || robot.odometryFrame >= 0 || robot.placedInMap) return result;
    // The odometry may have restarted while the station was away.
    Match second = leitstand::match(cloud, localAt(robot.sensorInMap, robot), robot.sensorInMap, {}, up,
                                    m_settings.match, m_settings.fit);
    return second.doubts == 0 ? second : result;
}

void ScanMatcher::refine(const ScanToMatch& scan, ReadyScan& ready, Match& match) {
    const LiveScan& live = scan.live;
    const Pose& guess = scan.guess;
    // Where odometry erred from scan to scan, it also erred within the turn.
    const TurnRefinementSettings& refinement = m_settings.refinement;
    const bool erred = scan.step.trusted && live.end != TurnEnd::Sweep &&
                       (distanceBetween(guess, match.scanInMap) > refinement.from ||
                        angleBetween(guess, match.scanInMap) > refinement.fromAngle);
    const bool on = refinement.on || m_settings.refined.contains(live.scan->robot) || erred;
    if (!on || match.doubts != 0) return;
    const auto drift = turnDrift(cleaned(live, scan.robot.body, match.scanInMap, scan.preparing, scan.others),
                                 localAt(guess, scan.robot), match.scanInMap, m_settings.refinement);
    if (!drift) return;
    LiveScan straight = live;
    straight.scan = std::make_shared<const Scan>(straightened(*live.scan, *drift));
    ReadyScan second = readyScan(straight, scan.robot.body, match.scanInMap, scan.preparing, scan.others);
    Match again =
        matched({straight, scan.robot, guess, scan.step, scan.others, scan.preparing}, second.reduced);
    if (again.doubts != 0 || again.icp.overlap < match.icp.overlap) return;
    ready = std::move(second);
    match = again;
}

void ScanMatcher::stand(const ScanToMatch& scan, ReadyScan& ready, Match& match) {
    const LiveScan& live = scan.live;
    const Step& step = scan.step;
    const bool turns = live.scan->organised() && live.end != TurnEnd::Sweep && live.motionKnown;
    const bool fits = match.doubts == 0,
               asPublished = fits && !wasPushed(live, scan.guess, match.scanInMap, step, m_settings.keyScans);
    if (asPublished || match.spun || !turns || !step.measured || live.isGuessed() ||
        step.moved.norm() <= m_settings.fit.jump)
        return;
    Eigen::Vector3d way(live.velocity.x(), live.velocity.y(), 0.0);
    way *= secondsBetween(live.scan->start, live.scan->end);
    TurnDrift drift;
    drift.whole.head<3>() = -(live.sensorInBase.linear().transpose() * way);
    LiveScan stood = live;
    stood.began.setZero();
    stood.scan = std::make_shared<const Scan>(straightened(*live.scan, drift));
    Pose there = scan.guess;
    there.translation() -= step.moved;
    Step turned = step;
    turned.trusted = true;
    turned.way = 0.0;
    turned.moved.setZero();
    ReadyScan second = readyScan(stood, scan.robot.body, there, scan.preparing, scan.others);
    Match found = matched({stood, scan.robot, there, turned, scan.others, scan.preparing}, second.reduced);
    if (found.doubts != 0 || found.icp.open > 0 || found.icp.overlap < m_settings.fit.spunOverlap) return;
    if (fits && (found.icp.overlap < match.icp.overlap || found.icp.rms >= match.icp.rms)) return;
    found.spun = true;
    ready = std::move(second);
    match = found;
}

bool ScanMatcher::isHeldByOdometry(const ScanToMatch& scan, const ReadyScan& ready) {
    const LiveScan& live = scan.live;
    const RobotTrack& robot = scan.robot;
    const Pose& guess = scan.guess;
    const bool followed = scan.step.measured && !live.isGuessed() && !robot.contradicted;
    if (!followed || !canBegin(live, ready.reduced, m_settings.fit)) return false;
    const LocalMap& about = localAt(guess, robot);
    if (about.scans.empty()) return false;
    const KeyScanRule& rule = m_settings.keyScans;
    if (newGround(ready.reduced, about, guess, rule.newGroundFrom) < m_settings.fit.leastNew) return false;
    return std::none_of(about.scans.begin(), about.scans.end(), [&](std::uint64_t id) {
        const LiveKeyScan& other = *find(id);
        const Pose inOther = other.pose.scanInMap.inverse() * guess;
        return filledShare(*other.scan, *ready.scan, inOther) > m_settings.loops.mostFilled;
    });
}

const LiveKeyScan* ScanMatcher::find(std::uint64_t id) const {
    const auto found =
        std::lower_bound(m_map.scans.begin(), m_map.scans.end(), id,
                         [](const LiveKeyScan& one, std::uint64_t wanted) { return one.id < wanted; });
    return found != m_map.scans.end() && found->id == id ? &*found : nullptr;
}

std::uint64_t ScanMatcher::partOf(const RobotTrack& robot) const {
    const LiveKeyScan* const key = find(robot.key);
    return key != nullptr ? key->part : 0;
}

}  // namespace leitstand
