#pragma once

namespace leitstand {

/// How a speed controller is tuned.
struct SpeedControllerSettings {
    double fullSpeed = 0.7;        ///< speed of the motor without load, at full voltage [m/s]
    double proportional = 3.0;     ///< voltage (share of the full one) per m/s of error
    double integral = 8.0;         ///< voltage (share of the full one) per m of error
    double maxAcceleration = 3.0;  ///< largest acceleration of the requested speed [m/s2]
};

/// Keeps one side of a drive at a speed (PI with feed-forward; paper, section 3: "a speed controller for each
/// chain"). The integral does not change while the voltage is at its limit, so that a stall has no effect
/// later.
class SpeedController {
public:
    explicit SpeedController(const SpeedControllerSettings& settings) : m_settings(settings) {}

    /// Returns the voltage, -1 to 1. @p wanted and @p measured: speeds [m/s]. @p seconds: time since the last
    /// call.
    [[nodiscard]] double step(double wanted, double measured, double seconds);
    /// Forgets the past. Call after a stop.
    void reset();

private:
    SpeedControllerSettings m_settings;
    double m_ramped = 0.0;    ///< requested speed with limited acceleration [m/s]
    double m_integral = 0.0;  ///< integral part of the voltage
};

}  // namespace leitstand
