#include "robots/control/speed_controller.h"

#include <algorithm>
#include <cmath>

namespace leitstand {

double SpeedController::step(double wanted, double measured, double seconds) {
    if (!std::isfinite(wanted) || !std::isfinite(measured) || !(seconds > 0.0)) return 0.0;
    const double most = m_settings.maxAcceleration * seconds;
    m_ramped += std::clamp(wanted - m_ramped, -most, most);
    const double error = m_ramped - measured;
    const double forward = m_ramped / m_settings.fullSpeed + m_settings.proportional * error;
    const double next = m_integral + m_settings.integral * error * seconds;
    const double voltage = forward + next;
    const bool pushesFurther = std::abs(voltage) > 1.0 && (voltage > 0.0) == (error > 0.0);
    if (!pushesFurther) m_integral = next;
    return std::clamp(forward + m_integral, -1.0, 1.0);
}

void SpeedController::reset() {
    m_ramped = 0.0;
    m_integral = 0.0;
}

}  // namespace leitstand
