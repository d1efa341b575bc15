#include "robots/simulation/sensors/laser/turning_pattern.h"

#include <cmath>
#include <numbers>

namespace leitstand::simulation {

std::chrono::nanoseconds TurningPattern::startOf(std::int64_t rawScan) const {
    return std::chrono::nanoseconds(rawScan * turn.count() / rawScans);
}

std::chrono::nanoseconds TurningPattern::shotAfter(int point) const {
    const double share = point / (shotsOfCircle * rawScans);
    return std::chrono::nanoseconds(std::llround(share * static_cast<double>(turn.count())));
}

int TurningPattern::row(std::int64_t rawScan) const {
    return static_cast<int>(rawScan % rawScans);
}

double TurningPattern::heading(std::int64_t rawScan) const {
    return 2.0 * std::numbers::pi * row(rawScan) / rawScans;
}

Eigen::Vector3d TurningPattern::direction(std::int64_t rawScan, int point) const {
    const double yaw = heading(rawScan), elevation = lowest + point * step;
    return {std::cos(elevation) * std::cos(yaw), std::cos(elevation) * std::sin(yaw), std::sin(elevation)};
}

std::int64_t TurningPattern::sliceOf(std::int64_t rawScan) const {
    return startOf(rawScan) / slice;
}

std::int64_t TurningPattern::firstFrom(std::chrono::nanoseconds since) const {
    return (since.count() * rawScans + turn.count() - 1) / turn.count();
}

}  // namespace leitstand::simulation
