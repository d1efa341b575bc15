#include "app/services/offline/offline_map.h"

#include <map>
#include <utility>

#include "core/mapping/offline_mapper.h"

namespace leitstand {
namespace {

constexpr double KeyDistance = 0.3;       ///< as live mapping chooses key scans [m]
constexpr double KeyAngle = degrees(10);  ///< as live mapping chooses key scans [rad]
constexpr double ReadPart = 0.4;          ///< of the whole work, about

/// Returns the indices of the scans that a live map would have taken.
std::vector<std::size_t> chosen(const std::vector<ScanPtr>& scans) {
    std::vector<std::size_t> kept;
    std::map<std::string, Pose> newest;
    for (std::size_t i = 0; i < scans.size(); ++i) {
        const Scan& scan = *scans[i];
        const auto before = newest.find(scan.robot);
        const bool moved = !scan.hasOdometry || before == newest.end() ||
                           distanceBetween(before->second, scan.sensorInOdom) >= KeyDistance ||
                           angleBetween(before->second, scan.sensorInOdom) >= KeyAngle;
        if (!moved) continue;
        newest[scan.robot] = scan.sensorInOdom;
        kept.push_back(i);
    }
    return kept;
}

/// Returns the pose of the first scan in the map, from which registration starts. Odometry is level, so the
/// map is level by it, with the robot's start at its origin. A hand-in needs no absolute position, and
/// foreign odometry may count from afar.
Pose firstInMap(const Scan& first, const Pose& sensorInBase) {
    Pose pose = first.hasOdometry ? first.sensorInOdom : sensorInBase;
    pose.translation().head<2>() -= (pose * sensorInBase.inverse()).translation().head<2>();
    return pose;
}

}  // namespace

Result<OfflineMap> mapOffline(const std::filesystem::path& mission, const Progress& progress) {
    const auto read = readMissionScans(
        mission, {[&progress](double fraction) { progress.done(ReadPart * fraction); }, progress.stop});
    if (!read) return read.error();
    OfflineMap result;
    result.read = read->scans.size();
    result.warnings = read->warnings;
    const std::vector<std::size_t> scans = chosen(read->scans);
    OfflineMapper mapper(RegistrationSettings{});
    for (std::size_t i = 0; i < scans.size(); ++i) {
        if (!mapper.add(read->scans[scans[i]], {{}, progress.stop})) break;
        progress.done(ReadPart +
                      (1.0 - ReadPart) * static_cast<double>(i + 1) / static_cast<double>(scans.size()));
    }
    const MapPtr map = mapper.map();
    if (map->scans.empty()) return result;
    const Pose first = firstInMap(*map->scans.front().scan, read->sensorsInBase[scans.front()]);
    for (std::size_t i = 0; i < map->scans.size(); ++i) {
        OfflineScan scan{map->scans[i], read->sensorsInBase[scans[i]], read->arrivals[scans[i]]};
        scan.scan.poseInMap = first * scan.scan.poseInMap;
        scan.scan.guessInMap = first * scan.scan.guessInMap;
        result.scans.push_back(std::move(scan));
    }
    return result;
}

}  // namespace leitstand
