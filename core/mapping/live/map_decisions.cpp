#include "core/mapping/live/map_decisions.h"

#include <algorithm>
#include <iterator>

#include "core/base/words.h"

namespace leitstand {
namespace {

constexpr std::uint64_t IdBlock = 1000;  ///< of key scan ids, for stations that do not hear each other

Error unknown(std::uint64_t id) {
    return Error{
        leitstand::fill(translate("leitstand::Station", "key scan {}: expected one of the map"), id)};
}

}  // namespace

ScanPosesSample MapDecisions::decided(std::vector<ScanPose> poses, Time now) {
    m_map.apply(poses);
    return {now, m_map.station, ScanPosesSample::Cause::Operator, std::move(poses)};
}

void MapDecisions::linkAgain(std::uint64_t id, std::span<const std::uint64_t> against, const Match& match,
                             Time now) {
    std::vector<LiveKeyScan> others;
    for (const std::uint64_t other : against) {
        if (const LiveKeyScan* const scan = m_map.find(other)) others.push_back(*scan);
    }
    std::vector<Link> links = m_map.graph.replace({*m_map.find(id), nullptr, others, match});
    if (!links.empty()) m_made = ScanLinksSample{now, m_map.station, std::move(links)};
    m_map.findParts();
}

Result<ScanPosesSample> MapDecisions::accept(std::uint64_t id, Time now) {
    const LiveKeyScan* scan = m_map.find(id);
    if (scan == nullptr) return unknown(id);
    ScanPose pose = scan->pose;
    pose.trust = ScanTrust::Certain;
    return decided({pose}, now);
}

Result<ScanPosesSample> MapDecisions::reject(std::uint64_t id, Time now) {
    const LiveKeyScan* scan = m_map.find(id);
    if (scan == nullptr) return unknown(id);
    ScanPose pose = scan->pose;
    pose.trust = ScanTrust::SetAside;
    return decided({pose}, now);
}

Result<ScanPosesSample> MapDecisions::retry(std::uint64_t id, const RetrySettings& settings, Time now) {
    const LiveKeyScan* scan = m_map.find(id);
    if (scan == nullptr) return unknown(id);
    const Pose guess = settings.guessInMap.value_or(scan->pose.scanInMap);
    std::vector<LiveKeyScan> others = m_map.map.scans;
    std::erase_if(others, [&](const LiveKeyScan& other) { return other.id == id; });
    const PointCloud cloud = settings.match.reduce == m_map.settings.match.reduce
                                 ? scan->reduced->unpacked()
                                 : reducedAgain(*scan->scan, settings.match);
    const LocalMap local = localMap(ofPart(others, partAt(others, guess)), guess, m_map.settings.local);
    const Match found =
        match(cloud, local, guess, {}, scan->up, settings.match, m_map.settings.fit, settings.match.wide);
    ScanPose pose{id,
                  found.scanInMap,
                  found.icp.rms,
                  found.icp.inlierRatio,
                  found.icp.overlap,
                  found.icp.certainty,
                  found.icp.converged,
                  found.doubts == 0 ? ScanTrust::Certain : ScanTrust::Uncertain,
                  found.doubts};
    if (found.doubts != 0) pose.scanInMap = scan->pose.scanInMap;
    if (has(scan->pose.doubts, ScanDoubt::Guessed))
        pose.doubts |= static_cast<std::uint8_t>(ScanDoubt::Guessed);
    ScanPosesSample decision = decided({pose}, now);
    if (found.doubts == 0 && m_map.settings.loops.on) linkAgain(id, local.scans, found, now);
    return decision;
}

Result<ScanPosesSample> MapDecisions::rewind(Time moment, Time now) {
    std::vector<ScanPose> poses;
    for (const LiveKeyScan& scan : m_map.map.scans) {
        if (scan.entered <= moment || scan.pose.trust == ScanTrust::SetAside) continue;
        poses.push_back(scan.pose);
        poses.back().trust = ScanTrust::SetAside;
    }
    if (poses.empty())
        return Error{translate("leitstand::Station", "rewind: no scan entered the map after that moment")};
    return decided(std::move(poses), now);
}

void MapDecisions::restore(const KeyScanSample& sample) {
    if (!sample.scan || m_map.find(sample.id) != nullptr) return;
    LiveKeyScan key;
    key.id = sample.id;
    key.scan = keptOf(sample.scan);
    key.sensorInBase = sample.sensorInBase;
    key.pose = {.scan = sample.id, .scanInMap = sample.scanInMap};
    key.matched = sample.matched;
    key.enteredAt = sample.scanInMap;
    key.entered = sample.stamp;
    key.reduced = m_map.promised(key);
    m_map.cropped.fit(key, m_map.clouds);
    const std::string robot = sample.scan->robot;
    const auto place =
        std::upper_bound(m_map.map.scans.begin(), m_map.map.scans.end(), key.id,
                         [](std::uint64_t id, const LiveKeyScan& scan) { return id < scan.id; });
    const auto before = std::distance(m_map.map.scans.begin(), place);
    m_map.map.scans.insert(place, std::move(key));
    m_map.nextId = std::max(m_map.nextId, sample.id + 1);
    m_map.matcher.mapChanged();
    for (auto newer = std::next(m_map.map.scans.begin(), before + 1); newer != m_map.map.scans.end();
         ++newer) {
        if (newer->scan->robot == robot) return;  // the robot is where that one saw it
    }
    RobotTrack& track = m_map.robots[robot];
    track.odometry = sample.scan->hasOdometry;
    track.sensorInOdom = sample.scan->sensorInOdom;
    track.odometryFrame = -1;
    track.stamp = sample.scan->end;
    track.sensorInBase = sample.sensorInBase;
    m_map.goOn(robot);
}

void MapDecisions::adopt(const KeyScanSample& sample) {
    if (!sample.scan) return;
    const LiveKeyScan* known = m_map.find(sample.id);
    if (known != nullptr && known->entered == sample.stamp) return;
    if (known != nullptr) {
        std::erase_if(m_map.map.scans, [&](const LiveKeyScan& scan) { return scan.id == sample.id; });
        m_map.cropped.forget(sample.id);
        m_map.graph.forget(sample.id);
        m_map.loops.forget(sample.id);
    }
    restore(sample);
    beginBlock();
}

void MapDecisions::beginBlock() {
    if (m_map.map.scans.empty()) return;
    const std::uint64_t newest = m_map.map.scans.back().id;
    m_map.nextId = std::max(m_map.nextId, (newest / IdBlock + 1) * IdBlock + 1);
    m_map.graph.beginBlock();
}

void MapDecisions::follow(std::span<const ScanPose> poses) {
    std::vector<ScanPose> all;
    for (const LiveKeyScan& scan : m_map.map.scans) {
        const auto logged = std::find_if(poses.begin(), poses.end(),
                                         [&](const ScanPose& pose) { return pose.scan == scan.id; });
        all.push_back(logged != poses.end() ? *logged : scan.pose);
        if (logged == poses.end()) all.back().trust = ScanTrust::SetAside;
    }
    m_map.apply(all);
}

}  // namespace leitstand
