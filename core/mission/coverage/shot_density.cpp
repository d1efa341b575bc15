#include "core/mission/coverage/shot_density.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/pose.h"

namespace leitstand {

int ShotDensity::columnOf(const Eigen::Vector3d& direction) {
    const double angle = inDegrees(std::atan2(direction.y(), direction.x()));
    return std::clamp(static_cast<int>((angle + 180.0) / 360.0 * Around), 0, Around - 1);
}

int ShotDensity::ringOf(const Eigen::Vector3d& direction) {
    const double angle = inDegrees(std::atan2(direction.z(), direction.head<2>().norm()));
    return std::clamp(static_cast<int>((angle + 90.0) / 180.0 * Rings), 0, Rings - 1);
}

ShotDensity ShotDensity::of(const Scan& scan) {
    ShotDensity density;
    for (const Eigen::Vector3f& point : scan.points) {
        if (!point.allFinite() || point.isZero()) continue;
        const Eigen::Vector3d direction = point.cast<double>();
        std::uint16_t& count =
            density.m_counts[static_cast<std::size_t>(ringOf(direction) * Around + columnOf(direction))];
        if (count < std::numeric_limits<std::uint16_t>::max()) ++count;
    }
    return density;
}

double ShotDensity::about(const Eigen::Vector3d& direction) const {
    if (!direction.allFinite()) return 0.0;
    const int ring = ringOf(direction), column = columnOf(direction);
    double points = 0.0, steradians = 0.0;
    for (int y = std::max(0, ring - 1); y <= std::min(Rings - 1, ring + 1); ++y) {
        const double low = degrees(y * 180.0 / Rings - 90.0), high = degrees((y + 1) * 180.0 / Rings - 90.0);
        const double area = (std::sin(high) - std::sin(low)) * degrees(360.0 / Around);
        for (int x = column - 1; x <= column + 1; ++x) {
            points += m_counts[static_cast<std::size_t>(y * Around + (x + Around) % Around)];
            steradians += area;
        }
    }
    return points / steradians;
}

}  // namespace leitstand
