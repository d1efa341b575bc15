#include "tests/simulation/mapping/two_drives.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "tests/simulation/mapping/building_sets.h"

namespace leitstand::simulation::test {

std::vector<Eigen::Vector3d> stretch(const BuildingWays& ways, double from, double to) {
    std::vector<Eigen::Vector3d> corners = ringRoute(ways, std::max(from, to));
    double left = std::min(from, to) * 2.0 * ways.ring.sizes().sum();
    while ((corners[1] - corners[0]).norm() <= left) {
        left -= (corners[1] - corners[0]).norm();
        corners.erase(corners.begin());
    }
    corners[0] += left * (corners[1] - corners[0]).normalized();
    if (to < from) std::reverse(corners.begin(), corners.end());
    return corners;
}

void rename(ScriptedDrive& drive, const std::string& robot) {
    for (LiveScan& live : drive.scans) {
        Scan scan = *live.scan;
        scan.robot = robot;
        live.scan = std::make_shared<const Scan>(std::move(scan));
    }
}

TwoDrives twoDrives(const Building& building, const SensorErrors& sensor, std::uint64_t seed) {
    ScriptSettings script;
    script.seed = seed;
    script.sensor = sensor;
    TwoDrives drives;
    drives.first = scriptedDrive(building.arena, DrivePath(stretch(building.ways, 0.0, 0.6)), script);
    script.seed = seed + 5000;
    drives.second = scriptedDrive(building.arena, DrivePath(stretch(building.ways, 0.8, 0.1)), script);
    rename(drives.second, "second");
    return drives;
}

}  // namespace leitstand::simulation::test
