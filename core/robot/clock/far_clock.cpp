#include "core/robot/clock/far_clock.h"

#include <chrono>
#include <cmath>

#include "core/base/time.h"

namespace leitstand {

double surelyOff(const ClockStatus& clock) {
    return std::abs(toSeconds(clock.ahead)) - toSeconds(clock.uncertainty);
}

}  // namespace leitstand
