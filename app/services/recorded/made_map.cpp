#include "app/services/recorded/made_map.h"

#include <algorithm>
#include <utility>

#include "app/services/offline/offline_map.h"
#include "core/base/words.h"
#include "core/event/map_samples.h"
#include "core/event/scan_pose.h"
#include "core/event/station_topics.h"

namespace leitstand {
namespace {

ScanPose poseOf(const MapScan& scan, std::uint64_t id) {
    ScanPose pose;
    pose.scan = id;
    pose.scanInMap = scan.poseInMap;
    pose.rms = scan.icp.rms;
    pose.inlierRatio = scan.icp.inlierRatio;
    pose.overlap = scan.registered ? scan.icp.overlap : 1.0;
    pose.certainty = scan.registered ? scan.icp.certainty : 1.0;
    pose.converged = !scan.registered || scan.icp.converged;
    return pose;
}

/// Returns the events of @p one, the scan of @p id. They are of its robot: an event of the station would need
/// a sequence that no other has.
std::pair<Event, Event> eventsOf(const OfflineScan& one, std::uint64_t id) {
    Event scan;
    scan.sequence = one.arrival.sequence;
    scan.received = one.arrival.received;
    scan.robot = one.scan.scan->robot;
    Event pose = scan;
    scan.topic = station_topic::KeyScans;
    scan.sample = KeyScanSample{.stamp = scan.received,
                                .id = id,
                                .scan = one.scan.scan,
                                .sensorInBase = one.sensorInBase,
                                .scanInMap = one.scan.poseInMap,
                                .matched = id - 1};
    pose.topic = station_topic::ScanPoses;
    pose.sample = ScanPosesSample{.stamp = scan.received,
                                  .station = {},
                                  .cause = ScanPosesSample::Cause::Registration,
                                  .poses = {poseOf(one.scan, id)}};
    return {std::move(scan), std::move(pose)};
}

}  // namespace

MadeMap madeMapOf(const std::filesystem::path& mission, const Progress& progress) {
    MadeMap made;
    auto map = mapOffline(mission, progress);
    if (!map) {
        made.warnings.push_back(map.error().text);
        return made;
    }
    made.warnings = map->warnings;
    made.warnings.push_back(
        fill(translate("leitstand::Station",
                       "no station made a map of this mission: {} of its {} scans were registered for the "
                       "review, without anyone's check"),
             map->scans.size(), map->read));
    std::vector<std::pair<Event, Event>> recorded;
    for (std::size_t i = 0; i < map->scans.size(); ++i) recorded.push_back(eventsOf(map->scans[i], i + 1));
    std::stable_sort(recorded.begin(), recorded.end(),
                     [](const auto& a, const auto& b) { return a.first.sequence < b.first.sequence; });
    // A turn that had not ended is complete with the last cloud, as is the turn before it. One of them comes
    // earlier, since a topic has one event at a time.
    for (std::size_t i = recorded.size(); i-- > 1;) {
        const std::uint64_t last = recorded[i].first.sequence - 1;
        if (recorded[i - 1].first.sequence <= last) continue;
        recorded[i - 1].first.sequence = recorded[i - 1].second.sequence = last;
    }
    for (auto& [scan, pose] : recorded) {
        made.events.push_back(std::move(scan));
        made.events.push_back(std::move(pose));
    }
    return made;
}

}  // namespace leitstand
