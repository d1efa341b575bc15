#pragma once

#include <optional>
#include <utility>

#include "core/base/time.h"
#include "core/mission/state/robot_state.h"
#include "core/robot/robot_description.h"

namespace leitstand {

/// Returns roll and pitch of the robot's body [rad], positive with the right side or the nose down. They come
/// from the inertial unit, otherwise from odometry. Empty when neither arrived within the last second.
[[nodiscard]] std::optional<std::pair<double, double>> rollAndPitch(const RobotDescription& description,
                                                                    const RobotState& reported, Time now);

/// Returns the larger of roll and pitch, each as a share of the limit where the robot tips over; 0 when no
/// limit is known.
[[nodiscard]] double shareOfLimits(const RobotDescription& description, double roll, double pitch);

/// How long a battery sample counts as current [s].
inline constexpr double BatteryAge = 10.0;
/// Returns the time until a robot's battery is empty at the mean load of the last minute [min]; NaN when that
/// is unknown.
[[nodiscard]] double minutesLeft(const RobotState& reported);

/// Whether @p latest was received within @p seconds before @p now, station's clock.
template <class T>
[[nodiscard]] bool isFresh(const LatestPtr<T>& latest, Time now, double seconds) {
    return latest && toSeconds(now - latest->received) < seconds;
}

}  // namespace leitstand
