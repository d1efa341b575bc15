#include "core/robot/clock/far_clock.h"

#include <chrono>
#include <cmath>

namespace leitstand {

double surelyOff(const ClockStatus& clock) {
    const auto seconds = [](std::chrono::nanoseconds time) {
        return std::chrono::duration<double>(time).count();
    };
    return std::abs(seconds(clock.ahead)) - seconds(clock.uncertainty);
}

}  // namespace leitstand
