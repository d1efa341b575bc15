#pragma once

#include <cmath>
#include <memory>
#include <vector>

#include "core/handin/map/occupancy_grid.h"
#include "core/handin/map/voxel_evidence.h"
#include "core/mapping/floor_heights.h"
#include "core/mapping/report_scan.h"
#include "tests/support/rooms.h"

namespace leitstand::test {

/// A room of 8 m x 6 m with furniture, seen from @p count places along its middle; labelled by truth.
inline std::vector<ReportScan> roomScans(int count = 3) {
    std::vector<ReportScan> scans;
    for (int i = 0; i < count; ++i) {
        RoomSettings settings;
        settings.sensorInRoom = poseFrom({-1.0 + 0.5 * i, 0, 0.5}, 0, 0, 0);
        settings.sweep = Sweep::Yawing;
        settings.rows = 360;
        settings.columns = 161;
        settings.seed = static_cast<unsigned>(i + 1);
        RoomScan room = scanRoom(settings);
        room.scan.labels = room.trueLabels;
        room.scan.robot = "kurt3d";
        room.scan.end = Time(std::chrono::seconds(100 + 5 * i));
        scans.push_back({.id = static_cast<std::uint64_t>(i + 1),
                         .scan = std::make_shared<const Scan>(room.scan),
                         .scanInMap = settings.sensorInRoom,
                         .sensorInBase = poseFrom({0, 0, 0.5}, 0, 0, 0)});
    }
    return scans;
}

/// roomScans() of the room and as many of one like it, @p up above it, which came later [m].
inline std::vector<ReportScan> storeyScans(int count, double up = 3.0) {
    std::vector<ReportScan> scans = roomScans(count);
    for (int i = 0; i < count; ++i) {
        ReportScan above = scans[static_cast<std::size_t>(i)];
        auto later = std::make_shared<Scan>(*above.scan);
        later->end += std::chrono::seconds(5 * count);
        above.id += static_cast<std::uint64_t>(count);
        above.scan = later;
        above.scanInMap.translation().z() += up;
        scans.push_back(above);
    }
    return scans;
}

/// Where the robot stood.
inline std::vector<Eigen::Vector3d> groundOf(const std::vector<ReportScan>& scans) {
    std::vector<Eigen::Vector3d> ground;
    for (const ReportScan& scan : scans) ground.push_back(scan.baseInMap().translation());
    return ground;
}

/// The map of a room at the lower height.
inline OccupancyGrid roomGrid(const std::vector<ReportScan>& scans) {
    return gridOf(VoxelEvidence::of(scans), FloorHeights::of(scans, groundOf(scans)), reportBands().front());
}

/// A scan of a few points, seen from the origin of the map.
inline ReportScan scanOf(std::vector<Eigen::Vector3f> points, std::vector<Label> labels = {}) {
    Scan scan;
    scan.points = std::move(points);
    scan.labels = std::move(labels);
    return {.id = 1, .scan = std::make_shared<const Scan>(scan)};
}

}  // namespace leitstand::test
