#pragma once

#include "core/robot/link/link_status.h"

namespace leitstand {

/// Least difference from the station's clock that makes a robot's clock far [s]. A robot whose readers have a
/// lifespan may then take every drive command for expired and drop it.
inline constexpr double FarClock = 1.0;

/// Returns the least possible difference of @p clock from the station's, its uncertainty taken off [s]; below
/// 0 when the clocks may agree.
[[nodiscard]] double surelyOff(const ClockStatus& clock);

}  // namespace leitstand
