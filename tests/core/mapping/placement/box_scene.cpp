#include "tests/core/mapping/placement/box_scene.h"

#include <cmath>
#include <limits>
#include <random>

namespace leitstand::test {
namespace {

constexpr int Headings = 180, Elevations = 161;
constexpr double Farthest = 15.0;  ///< [m]

}  // namespace

void BoxScene::add(const Eigen::Vector2d& middle, double heading, double length, double width,
                   double height) {
    m_boxes.push_back({poseFrom({middle.x(), middle.y(), Floor + 0.5 * height}, 0, 0, heading),
                       0.5 * Eigen::Vector3d(length, width, height)});
}

Scan BoxScene::scan(const Pose& sensorInMap, unsigned seed) const {
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0.0, 0.01);
    Scan scan;
    scan.robot = "kurt3d";
    const Eigen::Vector3d from = sensorInMap.translation();
    for (int i = 0; i < Headings; ++i) {
        for (int k = 0; k < Elevations; ++k) {
            const double heading = degrees(360.0 * i / Headings), up = degrees(k - 80.0);
            const Eigen::Vector3d inSensor(std::cos(up) * std::cos(heading), std::cos(up) * std::sin(heading),
                                           std::sin(up));
            const Eigen::Vector3d along = sensorInMap.linear() * inSensor;
            double nearest = along.z() < 0.0 ? (Floor - from.z()) / along.z() : Farthest;
            for (const Box& box : m_boxes) {
                const Eigen::Vector3d origin = box.inMap.inverse() * from,
                                      ray = box.inMap.linear().transpose() * along;
                double enter = 0.0, leave = Farthest;
                for (int axis = 0; axis < 3; ++axis) {
                    const double a = (-box.half[axis] - origin[axis]) / ray[axis],
                                 b = (box.half[axis] - origin[axis]) / ray[axis];
                    enter = std::max(enter, std::min(a, b));
                    leave = std::min(leave, std::max(a, b));
                }
                if (enter < leave && enter > 0.0) nearest = std::min(nearest, enter);
            }
            if (nearest < Farthest)
                scan.points.push_back(((nearest + noise(random)) * inSensor).cast<float>());
        }
    }
    return scan;
}

LocalMap BoxScene::map(const Pose& sensorInMap) const {
    LocalMap map;
    for (const Eigen::Vector3f& point : scan(sensorInMap, 99).points) {
        map.cloud.points.push_back((sensorInMap * point.cast<double>()).cast<float>());
        map.cloud.normals.emplace_back(0.0F, 0.0F, 0.0F);
    }
    map.search = makeSearch(map.cloud, SearchMethod::KdTree);
    return map;
}

}  // namespace leitstand::test
