#include "tests/core/mapping/live/mapped_room.h"

#include <algorithm>
#include <memory>

#include "core/event/station_samples.h"
#include "core/mission/state/scan_state.h"

namespace leitstand::test {

LiveScan scanAt(const Pose& sensorInRoom, unsigned seed, const Pose& drift) {
    RoomSettings room;
    room.sensorInRoom = sensorInRoom;
    room.sweep = Sweep::Yawing;
    room.rows = 121;
    room.columns = 81;
    room.seed = seed;
    Scan scan = scanRoom(room).scan;
    scan.robot = "kurt3d";
    scan.end = Time(std::chrono::seconds(1000 + seed));
    scan.sensorInOdom = sensorInRoom * drift;
    LiveScan live;
    live.up = sensorInRoom.linear().transpose() * Eigen::Vector3d::UnitZ();
    live.levelKnown = true;
    live.scan = std::make_shared<const Scan>(std::move(scan));
    return live;
}

std::uint64_t MapLog::publish(Sample sample, std::string topic) {
    if (const auto* keyScan = sample.as<KeyScanSample>()) m_keyScans.push_back(*keyScan);
    if (const auto* links = sample.as<ScanLinksSample>()) m_links.push_back(*links);
    Event event;
    event.sequence = ++m_sequence;
    event.topic = std::move(topic);
    event.sample = std::move(sample);
    m_fold.add(event);
    return m_sequence;
}

void MapLog::publish(const MapUpdate& update) {
    if (update.keyScan) publish(*update.keyScan, "/leitstand/key_scans");
    if (update.links) publish(*update.links, "/leitstand/scan_links");
    if (update.poses) publish(*update.poses);
    if (update.loop) publish(*update.loop, "/leitstand/scan_links");
}

std::uint64_t MapLog::undo(std::uint64_t sequence, LiveMapper& mapper) {
    UndoSample undo;
    undo.event = sequence;
    const std::uint64_t reported = publish(undo, "/leitstand/undo");
    mapper.follow(poses());
    mapper.followLoops(loopsOf(m_fold.state()));
    return reported;
}

std::vector<ScanPose> MapLog::poses() const {
    std::vector<ScanPose> poses;
    for (const auto& [id, scan] : *m_fold.state().keyScans) poses.push_back(scan.pose);
    return poses;
}

LiveMapper MapLog::readAgain(const LiveSettings& settings) const {
    LiveMapper mapper("station", settings);
    for (const KeyScanSample& keyScan : m_keyScans) mapper.restore(keyScan);
    for (const ScanLinksSample& links : m_links) mapper.restore(links);
    mapper.followLoops(loopsOf(m_fold.state()));
    mapper.follow(poses());
    return mapper;
}

MapUpdate MappedRoom::add(const Pose& sensorInRoom, const Pose& drift) {
    last = sensorInRoom;
    return add(scanAt(sensorInRoom, seed++, drift));
}

MapUpdate MappedRoom::add(const LiveScan& scan) {
    now += std::chrono::seconds(2);
    const MapUpdate update = mapper.add(scan, now);
    log.publish(update);
    return update;
}

void MappedRoom::drive(int scans) {
    for (int i = 0; i < scans; ++i) add(poseFrom({-1.4 + 0.4 * i, 0.05 * i, 0.9}, 0, 0, degrees(3) * i));
}

std::optional<ScanPosesSample> MappedRoom::solveAll() {
    const auto problem = mapper.problem();
    if (!problem) return std::nullopt;
    const Settled settled = mapper.settle(solve(*problem), now);
    if (settled.links) log.publish(*settled.links, "/leitstand/scan_links");
    if (settled.poses) log.publish(*settled.poses);
    return settled.poses;
}

std::vector<ScanPose> MappedRoom::poses() const {
    std::vector<ScanPose> poses;
    const LiveMapPtr map = mapper.map();
    for (const LiveKeyScan& scan : map->scans) poses.push_back(scan.pose);
    return poses;
}

bool alike(const std::vector<ScanPose>& a, const std::vector<ScanPose>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const ScanPose& one, const ScanPose& other) {
        return one.scan == other.scan && one.trust == other.trust && one.doubts == other.doubts &&
               distanceBetween(one.scanInMap, other.scanInMap) < 1e-3 &&
               angleBetween(one.scanInMap, other.scanInMap) < 1e-3;
    });
}

}  // namespace leitstand::test
