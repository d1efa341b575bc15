#pragma once

namespace leitstand {

/// How a speed controller is tuned.
struct SpeedControllerSettings {
    double fullSpeed = 0.7;        ///< of the motor without load, at full voltage [m/s]
    double proportional = 3.0;     ///< voltage (of 1) per m/s of error
    double integral = 8.0;         ///< voltage per m of error
    double maxAcceleration = 3.0;  ///< of the requested speed [m/s2]
};

/// Keeps one side of a drive at a speed (PI with feed-forward; paper, section 3: "a speed controller for each
/// chain"). The integral stands still while the voltage is at its limit, so that a stall leaves nothing
/// behind.
class SpeedController {
public:
    explicit SpeedController(const SpeedControllerSettings& settings) : m_settings(settings) {}

    /// Returns the voltage, -1 to 1, for @p wanted while @p measured [m/s], @p seconds after the last call.
    [[nodiscard]] double step(double wanted, double measured, double seconds);
    /// Forgets the past: after a stop.
    void reset();

private:
    SpeedControllerSettings m_settings;
    double m_ramped = 0.0;    ///< requested speed, after the limit of acceleration [m/s]
    double m_integral = 0.0;  ///< voltage
};

}  // namespace leitstand
