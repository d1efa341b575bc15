#include "tests/widgets/map_live/live_map.h"

#include "tests/widgets/map_view/maps.h"

namespace leitstand::test {
namespace {

RobotMark box(const Pose& baseInMap, double length, double width, double height) {
    RobotMark robot;
    robot.baseInMap = baseInMap;
    robot.footprint = {{length / 2, width / 2},
                       {-length / 2, width / 2},
                       {-length / 2, -width / 2},
                       {length / 2, -width / 2}};
    robot.height = height;
    return robot;
}

}  // namespace

MapPtr liveRoom(bool uncertain) {
    auto map = std::make_shared<Map>(*roomMap());
    for (std::size_t i = 0; i < map->scans.size(); ++i) {
        auto scan = std::make_shared<Scan>(*map->scans[i].scan);
        scan->robot = "kurt3d";
        map->scans[i].scan = std::move(scan);
        map->scans[i].id = i + 1;
    }
    map->scans[1].uncertain = uncertain;
    return map;
}

RobotMark kurt3d(const Pose& baseInMap) {
    RobotMark robot = box(baseInMap, 0.45, 0.33, 0.65);
    robot.face = {QStringLiteral("kurt3d"), QStringLiteral("K"), QStringLiteral("Kurt3D"), 0};
    robot.selected = true;
    auto trail = std::make_shared<Trail>();
    for (int i = 20; i > 0; --i) {
        trail->push_back({(baseInMap * Eigen::Vector3d(-0.1 * i, 0.02 * i * i * 0.1, 0)).cast<float>()});
    }
    robot.trail = trail;
    return robot;
}

RobotMark crawler(const Pose& baseInMap) {
    RobotMark robot = box(baseInMap, 0.40, 0.26, 0.35);
    robot.face = {QStringLiteral("crawler"), QStringLiteral("C"), QStringLiteral("Crawler"), 1};
    robot.tracked = true;
    return robot;
}

Pose onFloor(double x, double y, double heading) {
    return poseFrom({x, y, RoomFloor}, 0, 0, heading);
}

}  // namespace leitstand::test
