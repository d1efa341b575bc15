#include "tests/widgets/map_view/maps.h"

#include <algorithm>
#include <map>
#include <random>
#include <utility>

#include <fmt/format.h>

#include "tests/support/rooms.h"

namespace leitstand::test {
namespace {

MapScan roomScan(const Pose& sensorInRoom, const Pose& firstInRoom, unsigned seed) {
    RoomScan room = scanRoom({.sensorInRoom = sensorInRoom, .seed = seed});
    room.scan.name = fmt::format("scan{:03}", seed - 1);
    room.scan.labels = room.trueLabels;
    MapScan scan;
    scan.poseInMap = scan.guessInMap = firstInRoom.inverse() * sensorInRoom;
    scan.scan = std::make_shared<const Scan>(std::move(room.scan));
    return scan;
}

}  // namespace

MapPtr roomMap() {
    const Pose first = poseFrom({-2.0, 0.3, 1.0}, 0, 0, 0);
    const Pose second = poseFrom({-0.4, -0.5, 1.0}, 0, 0, degrees(20));
    auto map = std::make_shared<Map>();
    map->scans = {roomScan(first, first, 1), roomScan(second, first, 2)};
    map->scans[1].guessInMap = poseFrom({0.5, 0, 0}, 0, 0, degrees(10)) * map->scans[1].poseInMap;
    return map;
}

MapPtr mapOf(std::vector<Eigen::Vector3f> points, Label label) {
    auto scan = std::make_shared<Scan>();
    scan->name = "scan000";
    scan->labels.assign(points.size(), label);
    scan->points = std::move(points);
    return mapOf({scan});
}

ScanPtr blob(const Eigen::Vector3f& centre, Label label) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> offset(-0.05F, 0.05F);
    auto scan = std::make_shared<Scan>();
    scan->name = "blob";
    for (int i = 0; i < 2'000; ++i) {
        const Eigen::Vector3f away(offset(random), offset(random), offset(random));
        scan->points.emplace_back(centre + away);
    }
    scan->labels.assign(scan->points.size(), label);
    return scan;
}

MapPtr mapOf(const std::vector<ScanPtr>& scans) {
    auto map = std::make_shared<Map>();
    for (const ScanPtr& scan : scans) {
        MapScan entry;
        entry.scan = scan;
        map->scans.push_back(entry);
    }
    return map;
}

MapPtr largeMap(std::size_t count, std::size_t scanSize) {
    static std::map<std::pair<std::size_t, std::size_t>, MapPtr> made;
    MapPtr& map = made[{count, scanSize}];
    if (map) return map;
    std::vector<ScanPtr> scans;
    for (std::size_t first = 0; first < count; first += scanSize) {
        PointCloud cloud = roomCloud(std::min(scanSize, count - first), static_cast<unsigned>(first + 1));
        auto scan = std::make_shared<Scan>();
        scan->name = fmt::format("scan{:03}", first / scanSize);
        scan->points = std::move(cloud.points);
        scan->labels = std::move(cloud.labels);
        scans.push_back(std::move(scan));
    }
    map = mapOf(scans);
    return map;
}

}  // namespace leitstand::test
