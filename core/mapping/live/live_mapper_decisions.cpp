#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include "core/base/words.h"
#include "core/mapping/live/live_mapper.h"
#include "core/mapping/live/live_mapper_state.h"
#include "core/mapping/live/scan_doubts.h"

namespace leitstand {
namespace {

constexpr std::uint64_t IdBlock = 1000;  ///< of key scan ids, for stations that do not hear each other

Error unknown(std::uint64_t id) {
    return Error{
        leitstand::fill(translate("leitstand::Station", "key scan {}: expected one of the map"), id)};
}

bool same(const ScanPose& a, const ScanPose& b) {
    return a.trust == b.trust && a.doubts == b.doubts && a.converged == b.converged && a.rms == b.rms &&
           a.inlierRatio == b.inlierRatio && a.overlap == b.overlap && a.certainty == b.certainty &&
           a.scanInMap.matrix() == b.scanInMap.matrix();
}

}  // namespace

LiveKeyScan* LiveMapper::State::find(std::uint64_t id) {
    const auto found =
        std::lower_bound(map.scans.begin(), map.scans.end(), id,
                         [](const LiveKeyScan& scan, std::uint64_t wanted) { return scan.id < wanted; });
    return found != map.scans.end() && found->id == id ? &*found : nullptr;
}

void LiveMapper::State::goOn(const std::string& name) {
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

void LiveMapper::State::apply(std::span<const ScanPose> poses) {
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

ScanPosesSample LiveMapper::State::decided(std::vector<ScanPose> poses, Time now) {
    apply(poses);
    return {now, station, ScanPosesSample::Cause::Operator, std::move(poses)};
}

Result<ScanPosesSample> LiveMapper::accept(std::uint64_t id, Time now) {
    const LiveKeyScan* scan = m_state->find(id);
    if (scan == nullptr) return unknown(id);
    ScanPose pose = scan->pose;
    pose.trust = ScanTrust::Certain;
    return m_state->decided({pose}, now);
}

Result<ScanPosesSample> LiveMapper::reject(std::uint64_t id, Time now) {
    const LiveKeyScan* scan = m_state->find(id);
    if (scan == nullptr) return unknown(id);
    ScanPose pose = scan->pose;
    pose.trust = ScanTrust::SetAside;
    return m_state->decided({pose}, now);
}

Result<ScanPosesSample> LiveMapper::retry(std::uint64_t id, const RetrySettings& settings, Time now) {
    State& state = *m_state;
    const LiveKeyScan* scan = state.find(id);
    if (scan == nullptr) return unknown(id);
    const Pose guess = settings.guessInMap.value_or(scan->pose.scanInMap);
    std::vector<LiveKeyScan> others = state.map.scans;
    std::erase_if(others, [&](const LiveKeyScan& other) { return other.id == id; });
    const PointCloud cloud = settings.match.reduce == state.settings.match.reduce
                                 ? scan->reduced->unpacked()
                                 : reducedAgain(*scan->scan, settings.match);
    const LocalMap local = localMap(ofPart(others, partAt(others, guess)), guess, state.settings.local);
    const Match found =
        match(cloud, local, guess, {}, scan->up, settings.match, state.settings.fit, settings.match.wide);
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
    ScanPosesSample decision = state.decided({pose}, now);
    if (found.doubts == 0 && state.settings.loops.on) state.linkAgain(id, local.scans, found, now);
    return decision;
}

Result<ScanPosesSample> LiveMapper::rewind(Time moment, Time now) {
    std::vector<ScanPose> poses;
    for (const LiveKeyScan& scan : m_state->map.scans) {
        if (scan.entered <= moment || scan.pose.trust == ScanTrust::SetAside) continue;
        poses.push_back(scan.pose);
        poses.back().trust = ScanTrust::SetAside;
    }
    if (poses.empty())
        return Error{translate("leitstand::Station", "rewind: no scan entered the map after that moment")};
    return m_state->decided(std::move(poses), now);
}

void LiveMapper::restore(const KeyScanSample& sample) {
    State& state = *m_state;
    if (!sample.scan || state.find(sample.id) != nullptr) return;
    LiveKeyScan key;
    key.id = sample.id;
    key.scan = keptOf(sample.scan);
    key.sensorInBase = sample.sensorInBase;
    key.pose = {.scan = sample.id, .scanInMap = sample.scanInMap};
    key.matched = sample.matched;
    key.enteredAt = sample.scanInMap;
    key.entered = sample.stamp;
    key.reduced = state.promised(key);
    state.cropped.fit(key, state.clouds);
    const std::string robot = sample.scan->robot;
    const auto place =
        std::upper_bound(state.map.scans.begin(), state.map.scans.end(), key.id,
                         [](std::uint64_t id, const LiveKeyScan& scan) { return id < scan.id; });
    const auto before = std::distance(state.map.scans.begin(), place);
    state.map.scans.insert(place, std::move(key));
    state.nextId = std::max(state.nextId, sample.id + 1);
    state.matcher.mapChanged();
    for (auto newer = std::next(state.map.scans.begin(), before + 1); newer != state.map.scans.end();
         ++newer) {
        if (newer->scan->robot == robot) return;  // the robot is where that one saw it
    }
    RobotTrack& track = state.robots[robot];
    track.odometry = sample.scan->hasOdometry;
    track.sensorInOdom = sample.scan->sensorInOdom;
    track.odometryFrame = -1;
    track.stamp = sample.scan->end;
    track.sensorInBase = sample.sensorInBase;
    state.goOn(robot);
}

void LiveMapper::adopt(const KeyScanSample& sample) {
    if (!sample.scan) return;
    const LiveKeyScan* known = m_state->find(sample.id);
    if (known != nullptr && known->entered == sample.stamp) return;
    if (known != nullptr) {
        std::erase_if(m_state->map.scans, [&](const LiveKeyScan& scan) { return scan.id == sample.id; });
        m_state->cropped.forget(sample.id);
        m_state->loops.forget(sample.id);
    }
    restore(sample);
    beginBlock();
}

void LiveMapper::beginBlock() {
    if (m_state->map.scans.empty()) return;
    const std::uint64_t newest = m_state->map.scans.back().id;
    m_state->nextId = std::max(m_state->nextId, (newest / IdBlock + 1) * IdBlock + 1);
    m_state->loops.beginBlock();
}

void LiveMapper::follow(std::span<const ScanPose> poses) {
    std::vector<ScanPose> all;
    for (const LiveKeyScan& scan : m_state->map.scans) {
        const auto logged = std::find_if(poses.begin(), poses.end(),
                                         [&](const ScanPose& pose) { return pose.scan == scan.id; });
        all.push_back(logged != poses.end() ? *logged : scan.pose);
        if (logged == poses.end()) all.back().trust = ScanTrust::SetAside;
    }
    m_state->apply(all);
}

}  // namespace leitstand
