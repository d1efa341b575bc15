#pragma once

#include <cmath>
#include <memory>
#include <vector>

#include "core/event/picture_samples.h"
#include "core/mission/coverage/search_book.h"
#include "core/perception/pictures/pixel_ray.h"

namespace leitstand::test {

/// A hall of 8 m x 4 m about the origin with a wall across at x = 1 that leaves a door from y = 1 to y = 2,
/// and a cabin of 1 m x 1 m in a corner without a door. One scan, taken at (-2, 0, 0.5), that knows all of
/// it.
struct SearchScene {
    double wallHeight = 1.5;
    bool door = true;
    double cabinX = 3.0, cabinY = -1.0;  ///< its walls begin there

    [[nodiscard]] ReportScan scan() const {
        auto scan = std::make_shared<Scan>();
        scan->robot = "kurt3d";
        const Eigen::Vector3f from(-2.0F, 0.0F, 0.5F);
        const auto add = [&](double x, double y, double z, Label label) {
            scan->points.push_back(Eigen::Vector3d(x, y, z).cast<float>() - from);
            scan->labels.push_back(label);
        };
        constexpr double Step = 0.05;
        const auto wall = [&](double x, double y, double height) {
            for (double z = 0.0; z < height; z += Step) add(x, y, z, Label::Wall);
        };
        for (double x = -4.0; x < 4.0; x += Step) {
            for (double y = -2.0; y < 2.0; y += Step) add(x, y, 0.0, Label::Floor);
        }
        for (double x = -4.0; x < 4.0; x += Step) wall(x, -2.03, 1.5), wall(x, 2.03, 1.5);
        for (double y = -2.0; y < 2.0; y += Step) wall(-4.03, y, 1.5), wall(4.03, y, 1.5);
        for (double y = -2.0; y < (door ? 1.0 : 2.0); y += Step) wall(1.03, y, wallHeight);
        for (double x = cabinX; x < 4.0; x += Step) wall(x, cabinY, 1.5);
        for (double y = -2.0; y < cabinY; y += Step) wall(cabinX, y, 1.5);
        return {.id = 1,
                .scan = scan,
                .scanInMap = poseFrom(from.cast<double>(), 0, 0, 0),
                .sensorInBase = poseFrom({0, 0, 0.5}, 0, 0, 0)};
    }
    static std::vector<Eigen::Vector3d> trail() { return {{-2.5, 0.0, 0.0}, {-2.0, 0.0, 0.0}}; }
};

/// A camera of 640 x 480 pixels, 53 degrees wide.
inline CameraInfoSample sampleCamera() {
    CameraInfoSample info;
    info.width = 640;
    info.height = 480;
    info.intrinsics = {640, 0, 320, 0, 640, 240, 0, 0, 1};
    return info;
}

/// A view from @p place of the map, towards @p heading and down by @p down [rad], of the scene's scan.
inline SearchView viewFrom(const Eigen::Vector3d& place, double heading, double down = degrees(8),
                           SearchSensor sensor = SearchSensor::Camera) {
    const Pose scanInMap = SearchScene{}.scan().scanInMap;
    return {.scan = 1,
            .sensor = sensor,
            .cameraInScan = scanInMap.inverse() * opticalFrame(poseFrom(place, 0, down, heading)),
            .field = fieldOf(sampleCamera()).value_or(SearchField{})};
}

inline bool sees(const CoverageMap& map, SearchSensor sensor, double x, double y) {
    const auto cell = map.ground().cellAt({x, y});
    return cell >= 0 && map.seen(sensor, static_cast<std::size_t>(cell));
}
inline bool reachable(const SearchGround& ground, double x, double y) {
    const auto cell = ground.cellAt({x, y});
    return cell >= 0 && ground.isReachable(static_cast<std::size_t>(cell));
}

}  // namespace leitstand::test
