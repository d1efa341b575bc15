#pragma once

#include <optional>
#include <utility>

#include "core/base/time.h"
#include "core/mission/state/robot_state.h"
#include "core/robot/robot_description.h"

namespace leitstand {

/// Roll and pitch of the robot's body by its inertial unit, else by its odometry: right side down, nose down
/// [rad]; empty when neither came within the last second.
[[nodiscard]] std::optional<std::pair<double, double>> rollAndPitch(const RobotDescription& description,
                                                                    const RobotState& said, Time now);

/// The larger of the shares that roll and pitch have of the limits where the robot tips over; 0 where no
/// limit is known.
[[nodiscard]] double shareOfLimits(const RobotDescription& description, double roll, double pitch);

/// What a robot told of its battery is of now for so long [s].
inline constexpr double BatteryAge = 10.0;
/// Time until a robot's battery is empty at the mean load of the last minute [min]; NaN where that is not
/// told.
[[nodiscard]] double minutesLeft(const RobotState& said);

/// Whether @p latest came within @p seconds before @p now, station's clock.
template <class T>
[[nodiscard]] bool isFresh(const std::optional<Latest<T>>& latest, Time now, double seconds) {
    return latest && toSeconds(now - latest->received) < seconds;
}

}  // namespace leitstand
