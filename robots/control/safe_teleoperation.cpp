#include "robots/control/safe_teleoperation.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/robot/robot_says.h"

namespace leitstand {
namespace {

/// Returns the age of the oldest sector that @p wish drives into [s].
double ageAhead(const DriveVelocity& wish, const VirtualScanView& view) {
    constexpr double HalfAhead = 0.6;  // [rad]
    if (std::abs(wish.forward) < 1e-3) return view.oldest(-3.1415, 3.1415);
    const double middle = wish.forward > 0.0 ? 0.0 : 3.14159265;
    const double bend = std::clamp(0.5 * wish.turn, -0.8, 0.8) * (wish.forward > 0.0 ? 1.0 : -1.0);
    return view.oldest(middle + bend - HalfAhead, middle + bend + HalfAhead);
}

/// Returns the highest speed from which the robot stops within @p way [m/s].
double speedFor(double way, const SafeTeleoperationSettings& settings) {
    const double lag = settings.deceleration * settings.delay;
    return std::sqrt(lag * lag + 2.0 * settings.deceleration * std::max(0.0, way)) - lag;
}

/// Returns the speed that sectors of @p age [s] allow, at most @p wished [m/s].
double speedForAge(double age, double wished, const SafeTeleoperationSettings& settings) {
    if (age <= settings.freshAge) return wished;
    if (age >= settings.oldAge) return std::min(wished, settings.creep);
    const double share = (settings.oldAge - age) / (settings.oldAge - settings.freshAge);
    return std::max(std::min(wished, settings.creep), share * wished);
}

}  // namespace

SafeVelocity safeVelocity(const DriveVelocity& wish, const VirtualScanView& view,
                          const SafeTeleoperationSettings& settings) {
    SafeVelocity safe;
    safe.freeTravel = settings.lookAhead;
    if (!std::isfinite(wish.forward) || !std::isfinite(wish.turn)) {
        safe.share = 0.0;
        safe.reason = robot_says::NoNumber;
        return safe;
    }
    safe.velocity = {wish.forward, 0.0, wish.turn};
    const BodyBox body = settings.body.grown(settings.margin);
    const double speed = std::abs(wish.forward) + std::abs(wish.turn) * body.reach();
    if (speed < 1e-6) return safe;
    safe.freeTravel = view.freeTravel(wish.forward, wish.turn, body, settings.lookAhead);
    safe.age = ageAhead(wish, view);
    const double byWay =
        safe.freeTravel >= settings.lookAhead ? speed : std::min(speed, speedFor(safe.freeTravel, settings));
    const double byAge = speedForAge(safe.age, speed, settings);
    safe.share = std::min(byWay, byAge) / speed;
    if (byWay < speed && byWay <= byAge) {
        safe.reason = fmt::format(robot_says::Obstacle, fmt::format("{:.2f}", safe.freeTravel));
    } else if (byAge < speed) {
        safe.reason = std::isfinite(safe.age)
                          ? fmt::format(robot_says::OldScan, fmt::format("{:.1f}", safe.age))
                          : std::string(robot_says::NotSeenYet);
    }
    safe.velocity.forward *= safe.share;
    safe.velocity.turn *= safe.share;
    return safe;
}

}  // namespace leitstand
