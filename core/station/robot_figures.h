#pragma once

#include <optional>
#include <utility>

#include "core/base/time.h"
#include "core/mission/state/robot_state.h"
#include "core/robot/robot_description.h"

namespace leitstand {

/// Returns roll and pitch of the robot's body [rad], positive when the right side or the nose is down. They
/// come from the inertial unit, otherwise from odometry. Empty when neither was received within the last
/// second.
[[nodiscard]] std::optional<std::pair<double, double>> rollAndPitch(const RobotDescription& description,
                                                                    const RobotState& reported, Time now);

/// Returns roll or pitch, whichever is larger, as a share of the angle at which the robot tips over. 0 when
/// no such angle is known.
[[nodiscard]] double shareOfLimits(const RobotDescription& description, double roll, double pitch);

/// Age up to which a battery sample is used [s].
inline constexpr double BatteryAge = 10.0;
/// Returns the time until a robot's battery is empty, at the mean load of the last minute [min]; NaN:
/// unknown.
[[nodiscard]] double minutesLeft(const RobotState& reported);

/// Whether @p latest was received at most @p seconds before @p now (station's clock).
template <class T>
[[nodiscard]] bool isFresh(const LatestPtr<T>& latest, Time now, double seconds) {
    return latest && toSeconds(now - latest->received) < seconds;
}

}  // namespace leitstand
