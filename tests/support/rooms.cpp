#include "tests/support/rooms.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "tests/support/room_scene.h"

namespace leitstand::test {
namespace {

/// The direction of a shot in the sensor's frame (x forward, y left, z up).
Eigen::Vector3d shot(const RoomSettings& settings, int row, int column) {
    const double down = static_cast<double>(row), across = static_cast<double>(column);
    if (settings.sweep == Sweep::Tilting) {
        const double tilt = degrees(-48.0 + 116.0 * down / std::max(settings.rows - 1, 1));
        const double angle = degrees(-90.0 + 180.0 * across / std::max(settings.columns - 1, 1));
        return {std::cos(angle) * std::cos(tilt), std::sin(angle), std::cos(angle) * std::sin(tilt)};
    }
    const double heading = degrees(-180.0 + 360.0 * down / std::max(settings.rows, 1));
    const double elevation = degrees(-70.0 + 160.0 * across / std::max(settings.columns - 1, 1));
    return {std::cos(elevation) * std::cos(heading), std::cos(elevation) * std::sin(heading),
            std::sin(elevation)};
}

RoomScan scanScene(const RoomScene& scene, const RoomSettings& settings) {
    RoomScan result;
    Scan& scan = result.scan;
    scan.name = "room";
    scan.sensorInOdom = settings.sensorInRoom;
    scan.hasOdometry = true;
    scan.rows = settings.rows;
    scan.columns = settings.columns;
    scan.sweep = settings.sweep;
    const std::size_t size =
        static_cast<std::size_t>(settings.rows) * static_cast<std::size_t>(settings.columns);
    scan.points.assign(size, Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN()));
    result.trueLabels.assign(size, Label::Unlabelled);
    result.edgeDistances.assign(size, 0.0F);

    std::mt19937 random(settings.seed);
    std::normal_distribution<double> noise(0.0, 1.0);
    std::size_t i = 0;
    for (int row = 0; row < settings.rows; ++row) {
        for (int column = 0; column < settings.columns; ++column, ++i) {
            const Eigen::Vector3d direction = shot(settings, row, column);
            const double error = settings.rangeNoise * noise(random);
            const auto hit =
                scene.cast(settings.sensorInRoom.translation(), settings.sensorInRoom.linear() * direction);
            if (!hit) continue;
            scan.points[i] = ((hit->range + error) * direction).cast<float>();
            result.trueLabels[i] = trueLabel(hit->normal);
            result.edgeDistances[i] = static_cast<float>(scene.edgeDistance(*hit));
        }
    }
    return result;
}

}  // namespace

RoomScan scanRoom(const RoomSettings& settings) {
    return scanScene({settings.length, settings.width, settings.height, settings.furnished, false}, settings);
}

RoomScan scanCorridor(const RoomSettings& settings) {
    return scanScene({settings.length, 2.0, settings.height, false, true}, settings);
}

PointCloud roomCloud(std::size_t n, unsigned seed) {
    const RoomSettings room;
    const RoomScene scene(room.length, room.width, room.height, true, false);
    std::mt19937 random(seed);
    PointCloud cloud;
    for (std::size_t i = 0; i < n; ++i) {
        const Hit hit = scene.sample(random);
        cloud.points.push_back(hit.point.cast<float>());
        cloud.normals.push_back(hit.normal.cast<float>());
        cloud.labels.push_back(trueLabel(hit.normal));
    }
    return cloud;
}

PointCloud moved(const Pose& pose, const PointCloud& cloud) {
    PointCloud result = cloud;
    for (auto& point : result.points) point = (pose * point.cast<double>()).cast<float>();
    for (auto& normal : result.normals) normal = (pose.linear() * normal.cast<double>()).cast<float>();
    return result;
}

}  // namespace leitstand::test
