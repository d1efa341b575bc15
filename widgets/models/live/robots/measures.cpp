#include "widgets/models/live/robots/measures.h"

#include <algorithm>
#include <cmath>

#include "core/robot/model/model_body.h"

namespace leitstand {

Measures measuresOf(const RobotDescription& robot) {
    Measures measures{robot.footprint, robot.height, {}};
    for (const auto& [name, sensor] : robot.sensors)
        measures.sensors.push_back({name, sensor.frame, sensor.sensorInBase});
    for (const StreamDescription& stream : robot.streams) {
        const bool known = std::any_of(measures.sensors.begin(), measures.sensors.end(),
                                       [&](const SensorPlace& one) { return one.name == stream.sensor; });
        if (!stream.sensor.empty() && !known)
            measures.sensors.push_back({stream.sensor, stream.sensor, Pose::Identity()});
    }
    std::sort(measures.sensors.begin(), measures.sensors.end(),
              [](const SensorPlace& a, const SensorPlace& b) { return a.name < b.name; });
    return measures;
}

Sides sidesOf(const std::vector<Eigen::Vector2d>& footprint) {
    Sides sides;
    bool first = true;
    for (const Eigen::Vector2d& corner : footprint) {
        sides.front = first ? corner.x() : std::max(sides.front, corner.x());
        sides.rear = first ? -corner.x() : std::max(sides.rear, -corner.x());
        sides.left = first ? corner.y() : std::max(sides.left, corner.y());
        sides.right = first ? -corner.y() : std::max(sides.right, -corner.y());
        first = false;
    }
    return sides;
}

bool isRectangle(const std::vector<Eigen::Vector2d>& footprint) {
    constexpr double Nearest = 1e-6;  // [m]
    const Sides sides = sidesOf(footprint);
    return footprint.size() == 4 &&
           std::all_of(footprint.begin(), footprint.end(), [&](const Eigen::Vector2d& corner) {
               const bool alongX = std::abs(corner.x() - sides.front) < Nearest ||
                                   std::abs(corner.x() + sides.rear) < Nearest;
               const bool alongY = std::abs(corner.y() - sides.left) < Nearest ||
                                   std::abs(corner.y() + sides.right) < Nearest;
               return alongX && alongY;
           });
}

std::vector<Eigen::Vector2d> footprintOf(const Sides& sides) {
    return {{sides.front, sides.left},
            {-sides.rear, sides.left},
            {-sides.rear, -sides.right},
            {sides.front, -sides.right}};
}

Measures withModel(Measures measures, const ModelBody& body, std::string& problem) {
    problem.clear();
    if (const auto extent = extentOf(body)) {
        measures.footprint = extent->footprint;
        measures.height = extent->height;
    } else {
        problem = extent.error().text;
    }
    const auto poses =
        linksInBase(body.model, body.base, [](const std::string&) { return std::optional<double>(); });
    for (SensorPlace& sensor : measures.sensors) {
        if (const auto link = body.model.linkAt(sensor.frame)) sensor.sensorInBase = poses[*link];
    }
    return measures;
}

}  // namespace leitstand
