#pragma once

#include "core/robot/link/link_status.h"

namespace leitstand {

/// A robot's clock is far off if it differs by at least this from the station's [s]. If the robot's readers
/// have a lifespan, they may then treat every drive command as expired and drop it.
inline constexpr double FarClock = 1.0;

/// Returns how much @p clock certainly differs from the station's: the difference minus its uncertainty [s].
/// Below 0 when the clocks may agree.
[[nodiscard]] double surelyOff(const ClockStatus& clock);

}  // namespace leitstand
