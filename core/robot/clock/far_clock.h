#pragma once

#include "core/robot/link/link_status.h"

namespace leitstand {

/// Least difference from the station's clock that makes a robot's clock far [s]. A robot whose readers have a
/// lifespan may then take every drive command for expired and drop it.
inline constexpr double FarClock = 1.0;

/// Returns how much @p clock surely differs from the station's: the difference minus its uncertainty [s].
/// Below 0 when the clocks may agree.
[[nodiscard]] double surelyOff(const ClockStatus& clock);

}  // namespace leitstand
