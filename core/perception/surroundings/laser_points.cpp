#include "core/perception/surroundings/laser_points.h"

#include <chrono>
#include <cmath>
#include <optional>

#include "core/event/cloud_sample.h"

namespace leitstand {

std::vector<Eigen::Vector3f> laserPoints(const RangesSample& turn, const Pose& sensorInBase,
                                         const BaseInOdomAt& baseInOdom) {
    constexpr std::chrono::milliseconds Step(5);  // a robot hardly moves in this time
    std::vector<Eigen::Vector3f> points;
    points.reserve(turn.ranges.size());
    std::optional<Pose> sensor;
    Time sensorAt{};
    for (std::size_t i = 0; i < turn.ranges.size(); ++i) {
        const auto range = static_cast<double>(turn.ranges[i]);
        const bool echo = std::isfinite(range) && range > 0.0 && range >= turn.rangeMin &&
                          (turn.rangeMax <= 0.0 || range <= turn.rangeMax);
        if (!echo) continue;
        const auto number = static_cast<double>(i);
        const Time at = turn.header.stamp +
                        std::chrono::nanoseconds(static_cast<std::int64_t>(number * turn.timeStep * 1e9));
        if (!sensor || at - sensorAt >= Step) {
            const std::optional<Pose> base = baseInOdom(at);
            sensor = base ? std::optional<Pose>(*base * sensorInBase) : std::nullopt;
            sensorAt = at;
        }
        if (!sensor) continue;
        const double angle = turn.angleMin + number * turn.angleStep;
        const Eigen::Vector3d point =
            *sensor * Eigen::Vector3d(range * std::cos(angle), range * std::sin(angle), 0.0);
        if (point.allFinite()) points.emplace_back(point.cast<float>());
    }
    return points;
}

}  // namespace leitstand
