#include "core/mapping/live/growing_map.h"

#include <algorithm>
#include <chrono>
#include <memory>

#include "core/mapping/live/scan_doubts.h"
#include "core/mapping/live/scan_work.h"

namespace leitstand {
namespace {

constexpr std::chrono::seconds ClockStep(1);  ///< a station's clock that goes back farther was set

bool same(const ScanPose& a, const ScanPose& b) {
    return a.trust == b.trust && a.doubts == b.doubts && a.converged == b.converged && a.rms == b.rms &&
           a.inlierRatio == b.inlierRatio && a.overlap == b.overlap && a.certainty == b.certainty &&
           a.scanInMap.matrix() == b.scanInMap.matrix();
}

}  // namespace

std::set<std::uint64_t> leaveUnheld(std::vector<Link>& links, std::span<const ScanInPart> scans) {
    std::set<std::uint64_t> unheld = unheldLoops(links, scans);
    for (Link& link : links) link.active = link.active && !unheld.contains(link.id);
    return unheld;
}

bool GrowingMap::empty() const {
    return std::none_of(map.scans.begin(), map.scans.end(),
                        [](const LiveKeyScan& scan) { return scan.counts(); });
}

LiveKeyScan* GrowingMap::find(std::uint64_t id) {
    const auto found =
        std::lower_bound(map.scans.begin(), map.scans.end(), id,
                         [](const LiveKeyScan& scan, std::uint64_t wanted) { return scan.id < wanted; });
    return found != map.scans.end() && found->id == id ? &*found : nullptr;
}

std::vector<ScanInPart> GrowingMap::scansInParts() const {
    std::vector<ScanInPart> scans;
    scans.reserve(map.scans.size());
    for (const LiveKeyScan& scan : map.scans)
        scans.push_back({scan.id, scan.matched, scan.begins(), scan.enteredAt, scan.part});
    return scans;
}

std::uint64_t GrowingMap::partOf(const RobotTrack& robot) {
    const LiveKeyScan* const key = find(robot.key);
    return key != nullptr ? key->part : 0;
}

void GrowingMap::findParts() {
    std::vector<ScanInPart> scans = scansInParts();
    std::set<std::uint64_t> before, joined;  // parts that were there, and those that belong to others now
    for (const ScanInPart& scan : scans) before.insert(scan.part);
    std::vector<Link> links = graph.links();
    graph.setUnheld(leaveUnheld(links, scans));
    leitstand::findParts(scans, MapParts(links));
    bool changed = false;
    for (std::size_t i = 0; i < scans.size(); ++i) {
        const std::uint64_t was = map.scans[i].part;
        if (scans[i].part == was) continue;
        changed = true;
        if (was != 0 && before.contains(scans[i].part)) joined.insert(was);
    }
    if (!changed) return;
    // Parts that came apart do not meet any more. Parts that came together may see the same elsewhere, too.
    meeting.clear();
    (void)loops.forgetMet();
    for (std::size_t i = 0; i < scans.size(); ++i) {
        LiveKeyScan& scan = map.scans[i];
        if (scan.counts() && joined.contains(scan.part) && !joined.contains(scans[i].part))
            meeting.push_back(scan.id);
        if (scans[i].part == scan.part) continue;
        scan.part = scans[i].part;
        cropped.fit(scan, clouds);
    }
    matcher.mapChanged();
}

bool GrowingMap::awaitsDecision(const std::string& robot) const {
    const auto newest = std::find_if(map.scans.rbegin(), map.scans.rend(), [&](const LiveKeyScan& scan) {
        return scan.scan->robot == robot && scan.pose.trust != ScanTrust::SetAside;
    });
    return newest != map.scans.rend() && newest->pose.trust == ScanTrust::Uncertain;
}

Time GrowingMap::entering(Time now) {
    const bool behind = now <= entered && entered - now < ClockStep;
    entered = behind ? entered + std::chrono::nanoseconds(1) : now;
    return entered;
}

void GrowingMap::apply(std::span<const ScanPose> poses) {
    std::map<std::string, std::uint64_t> newest;  // key scan of each robot, whatever its trust
    for (const LiveKeyScan& scan : map.scans) newest[scan.scan->robot] = scan.id;
    std::vector<std::string> moved;
    ++revision;
    for (const ScanPose& pose : poses) {
        LiveKeyScan* scan = find(pose.scan);
        if (scan == nullptr || same(scan->pose, pose)) continue;
        if (!scan->pose.scanInMap.isApprox(pose.scanInMap)) loops.moved();
        scan->pose = pose;
        cropped.fit(*scan, clouds);
        matcher.mapChanged();
        const std::string& robot = scan->scan->robot;
        if (newest[robot] == scan->id) moved.push_back(robot);
    }
    findParts();
    for (const std::string& robot : moved) goOn(robot);
}

void GrowingMap::goOn(const std::string& name) {
    const auto newest = std::find_if(map.scans.rbegin(), map.scans.rend(), [&](const LiveKeyScan& scan) {
        return scan.scan->robot == name && scan.pose.trust != ScanTrust::SetAside;
    });
    if (newest == map.scans.rend()) return;
    RobotTrack& robot = robots[name];
    const Pose& inMap = newest->pose.scanInMap;
    const bool together =
        robot.odometry && newest->scan->hasOdometry && robot.odometryFrame == newest->odometryFrame;
    const Pose moved =
        together ? newest->sensorByWheels().inverse() * robot.unspun * robot.sensorInOdom : Pose::Identity();
    robot.known = true;
    robot.key = newest->id;
    robot.sensorInMap = inMap * moved;
    robot.keyInMap = inMap;
    robot.lost = !newest->counts();
    robot.contradicted = robot.contradicted && robot.lost;
    robot.beginsPart = false;
    robot.certainty = newest->matched == 0 ? 1.0 : certaintyOf(newest->pose.overlap, newest->pose.certainty);
    robot.doubts = newest->counts() ? std::uint8_t{0} : newest->pose.doubts;
    robot.way = moved.translation().norm();
    robot.turn = Eigen::AngleAxisd(moved.linear()).angle();
    robot.moved = robot.sensorInMap.translation() - inMap.translation();
}

void GrowingMap::linksChanged() {
    ++revision;
    unsolved = true;
}

MatchedCloudPtr GrowingMap::matchedOf(LiveKeyScan& key, const PointCloud& reduced) const {
    key.kept = std::make_shared<KeptScan>(key.scan);
    return clouds.keep(
        reduced, [kept = key.kept, match = settings.match] { return reducedAgain(*kept->whole(), match); });
}

MatchedCloudPtr GrowingMap::promised(LiveKeyScan& key) const {
    key.kept = std::make_shared<KeptScan>(key.scan);
    return clouds.promise(
        [kept = key.kept, match = settings.match] { return reducedAgain(*kept->whole(), match); });
}

}  // namespace leitstand
