#include "tests/core/perception/virtual_world.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "core/event/cloud_sample.h"

namespace leitstand::test {
namespace {

constexpr double Turn = 2.3;
constexpr int RawScans = 180, Points = 161;
constexpr double Nothing = std::numeric_limits<double>::infinity();

double castBlock(const Block& block, const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) {
    double enter = 0.0, leave = Nothing;
    for (int axis = 0; axis < 3; ++axis) {
        const double step = direction[axis];
        if (std::abs(step) < 1e-12) {
            if (origin[axis] < block.low[axis] || origin[axis] > block.high[axis]) return Nothing;
            continue;
        }
        const double a = (block.low[axis] - origin[axis]) / step,
                     b = (block.high[axis] - origin[axis]) / step;
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
    }
    return enter <= leave && enter > 0.0 ? enter : Nothing;
}

}  // namespace

double VirtualWorld::cast(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) const {
    double range = Nothing;
    for (const Block& block : blocks) range = std::min(range, castBlock(block, origin, direction));
    const auto floorAt = [this](const Eigen::Vector3d& place) {
        if (place.x() > hole) return -1.0;
        if (stairs && place.x() > stairs->from)
            return -stairs->riser * std::ceil((place.x() - stairs->from) / stairs->tread);
        if (!incline || place.x() < incline->from) return 0.0;
        return std::min(1.0, (place.x() - incline->from) / (incline->to - incline->from)) * incline->height;
    };
    // The floor by steps, then by halves.
    for (double far = 0.1; far < std::min(range, 20.0); far += 0.02) {
        const Eigen::Vector3d place = origin + far * direction;
        if (place.z() > floorAt(place)) continue;
        double low = far - 0.02, high = far;
        for (int i = 0; i < 20; ++i) {
            const double middle = 0.5 * (low + high);
            const Eigen::Vector3d there = origin + middle * direction;
            (there.z() > floorAt(there) ? low : high) = middle;
        }
        return std::min(range, high);
    }
    return range;
}

CloudSample VirtualWorld::slice(Time start, const BaseInOdomAt& base, std::mt19937& random) const {
    std::normal_distribution<double> error(0.0, std::max(noise, 1e-9));
    CloudSample cloud;
    cloud.header = {start, "robot/scanner"};
    cloud.columns = Points;
    const double from = std::chrono::duration<double>(start.time_since_epoch()).count();
    const int first = static_cast<int>(std::ceil(from / Turn * RawScans - 1e-6));
    for (int k = first; k / (RawScans / Turn) < from + 0.1 - 1e-9; ++k) {
        const double at = k * Turn / RawScans;
        const auto offset = static_cast<std::int64_t>((at - from) * 1e9);
        const Pose scanner = *base(start + std::chrono::nanoseconds(offset)) * scannerInBase;
        const double heading = k * 2.0 * std::numbers::pi / RawScans;
        for (int i = 0; i < Points; ++i) {
            const double up = degrees(-70.0 + i);
            const Eigen::Vector3d direction(std::cos(heading) * std::cos(up),
                                            std::sin(heading) * std::cos(up), std::sin(up));
            const double range = cast(scanner.translation(), scanner.linear() * direction) + error(random);
            const bool echo = range < 30.0;
            cloud.points.push_back(echo ? Eigen::Vector3f((range * direction).cast<float>())
                                        : Eigen::Vector3f::Constant(std::nanf("")));
            cloud.times.push_back(offset);
        }
        ++cloud.rows;
    }
    return cloud;
}

void scan(const VirtualWorld& world, VirtualScan& scan, const BaseInOdomAt& base, double from, double to) {
    std::mt19937 random(5);
    for (int k = static_cast<int>(std::lround(from * 10)); k < static_cast<int>(std::lround(to * 10)); ++k)
        scan.add(world.slice(atSecond(0.1 * k), base, random), world.scannerInBase, base);
}

Time atSecond(double seconds) {
    return Time(std::chrono::nanoseconds(std::llround(seconds * 1e9)));
}

BaseInOdomAt standing(const Pose& pose) {
    return [pose](Time) { return std::optional<Pose>(pose); };
}

}  // namespace leitstand::test
