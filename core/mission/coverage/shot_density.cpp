#include "core/mission/coverage/shot_density.h"

#include <algorithm>
#include <cmath>
#include <vector>

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
    std::vector<double> counts(static_cast<std::size_t>(Around * Rings));
    for (const Eigen::Vector3f& point : scan.points) {
        if (!point.allFinite() || point.isZero()) continue;
        const Eigen::Vector3d direction = point.cast<double>();
        counts[static_cast<std::size_t>(ringOf(direction) * Around + columnOf(direction))] += 1.0;
    }
    ShotDensity density;
    for (int ring = 0; ring < Rings; ++ring) {
        const int first = std::max(0, ring - 1), last = std::min(Rings - 1, ring + 1);
        const double low = degrees(first * 180.0 / Rings - 90.0);
        const double high = degrees((last + 1) * 180.0 / Rings - 90.0);
        const double steradians = (std::sin(high) - std::sin(low)) * degrees(3 * 360.0 / Around);
        for (int column = 0; column < Around; ++column) {
            double points = 0.0;
            for (int y = first; y <= last; ++y) {
                for (int x = column - 1; x <= column + 1; ++x)
                    points += counts[static_cast<std::size_t>(y * Around + (x + Around) % Around)];
            }
            density.m_densities[static_cast<std::size_t>(ring * Around + column)] =
                static_cast<float>(points / steradians);
        }
    }
    return density;
}

double ShotDensity::about(const Eigen::Vector3d& direction) const {
    if (!direction.allFinite()) return 0.0;
    return m_densities[static_cast<std::size_t>(ringOf(direction) * Around + columnOf(direction))];
}

}  // namespace leitstand
