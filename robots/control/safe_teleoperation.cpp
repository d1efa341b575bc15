#include "robots/control/safe_teleoperation.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/robot/robot_format.h"

namespace leitstand {
namespace {

/// Returns the age of the oldest sector that @p requested drives into [s].
double ageAhead(const DriveVelocity& requested, const VirtualScanView& view) {
    constexpr double HalfAhead = 0.6;  // [rad]
    if (std::abs(requested.forward) < 1e-3) return view.oldest(-3.1415, 3.1415);
    const double middle = requested.forward > 0.0 ? 0.0 : 3.14159265;
    const double bend = std::clamp(0.5 * requested.turn, -0.8, 0.8) * (requested.forward > 0.0 ? 1.0 : -1.0);
    return view.oldest(middle + bend - HalfAhead, middle + bend + HalfAhead);
}

/// Returns the highest speed from which the robot stops within @p way [m/s].
double speedFor(double way, const SafeTeleoperationSettings& settings) {
    const double lag = settings.deceleration * settings.delay;
    return std::sqrt(lag * lag + 2.0 * settings.deceleration * std::max(0.0, way)) - lag;
}

/// Returns the speed that sectors of @p age [s] allow, at most @p requested [m/s].
double speedForAge(double age, double requested, const SafeTeleoperationSettings& settings) {
    if (age <= settings.freshAge) return requested;
    if (age >= settings.oldAge) return std::min(requested, settings.creep);
    const double share = (settings.oldAge - age) / (settings.oldAge - settings.freshAge);
    return std::max(std::min(requested, settings.creep), share * requested);
}

}  // namespace

SafeVelocity safeVelocity(const DriveVelocity& requested, const VirtualScanView& view,
                          const SafeTeleoperationSettings& settings) {
    SafeVelocity safe;
    safe.freeTravel = settings.lookAhead;
    if (!std::isfinite(requested.forward) || !std::isfinite(requested.turn)) {
        safe.share = 0.0;
        safe.reason = robot_format::NoNumber;
        return safe;
    }
    safe.velocity = {requested.forward, 0.0, requested.turn};
    const BodyBox body = settings.body.grown(settings.margin);
    const double speed = std::abs(requested.forward) + std::abs(requested.turn) * body.reach();
    if (speed < 1e-6) return safe;
    safe.freeTravel = view.freeTravel(requested.forward, requested.turn, body, settings.lookAhead);
    safe.age = ageAhead(requested, view);
    const double byWay =
        safe.freeTravel >= settings.lookAhead ? speed : std::min(speed, speedFor(safe.freeTravel, settings));
    const double byAge = speedForAge(safe.age, speed, settings);
    safe.share = std::min(byWay, byAge) / speed;
    if (byWay < speed && byWay <= byAge) {
        safe.reason = fmt::format(robot_format::Obstacle, fmt::format("{:.2f}", safe.freeTravel));
    } else if (byAge < speed) {
        safe.reason = std::isfinite(safe.age)
                          ? fmt::format(robot_format::OldScan, fmt::format("{:.1f}", safe.age))
                          : std::string(robot_format::NotSeenYet);
    }
    safe.velocity.forward *= safe.share;
    safe.velocity.turn *= safe.share;
    return safe;
}

}  // namespace leitstand
