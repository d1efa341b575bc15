#pragma once

#include "core/robot/link/link_status.h"

namespace leitstand {

/// A robot's clock that is so far beside the station's is far: a robot whose readers have a lifespan may then
/// take every drive command for too old and drop it [s].
inline constexpr double FarClock = 1.0;

/// How far @p clock is beside the station's at least: what is uncertain is taken off; below 0: nobody knows
/// whether it is [s].
[[nodiscard]] double surelyOff(const ClockStatus& clock);

}  // namespace leitstand
