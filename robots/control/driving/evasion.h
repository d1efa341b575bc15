#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/base/time.h"
#include "core/robot/control/drive_setpoint.h"

namespace leitstand {

struct EvasionSettings {
    double backFrom = 0.5;  ///< it backs out if it leans more than this share of the tip-over limit
    double slowFrom = 0.2;  ///< above this share it drives more slowly
    double slowest = 0.4;   ///< share of the speed at backFrom
    double speed = 0.12;    ///< speed while it backs out [m/s]
    double way = 0.35;      ///< distance that it backs out [m]
    double within = 5.0;    ///< longest time that it backs out [s]
    double apart = 4.0;     ///< what is felt within this time after an evasion belongs to it [s]
    int most = 5;           ///< largest number of consecutive tries
};

/// Sides of a robot.
enum class BodySide : std::uint8_t { Front, Left, Rear, Right };

/// One step of evading.
struct EvasionStep {
    std::optional<DriveVelocity> velocity;  ///< velocity to drive instead of that of the driver
    std::optional<BodySide> felt;           ///< where something was just felt
    bool touched = false;                   ///< the robot touched something; false: it leaned too much
    bool failed = false;                    ///< the robot finds no way out
    std::string reason;                     ///< English text
};

/// Backs out of what the scanner does not see: low things that the robot runs into, and ground on which it
/// leans too much (paper, section 3: the Crawler). Pure: times are passed in.
class Evasion {
public:
    explicit Evasion(const EvasionSettings& settings = {}) : m_settings(settings) {}

    /// Sets how far the robot leans, as a share of the tip-over limit.
    void lean(double share) { m_lean = share; }
    void bumped(BodySide side) { m_bump = side; }
    /// Forgets a running evasion, because somebody else drives.
    void reset();

    /// @p wanted: what the driver wanted last. Call at least 10 times a second.
    [[nodiscard]] EvasionStep step(const DriveVelocity& wanted, const Pose& baseInOdom, Time now);
    /// Returns the share of the speed that is allowed at the present lean, 0 to 1.
    [[nodiscard]] double caution() const;
    [[nodiscard]] bool isActive() const { return m_back != 0; }

private:
    void begin(int back, const Pose& baseInOdom, Time now, const std::string& reason);

    EvasionSettings m_settings;
    double m_lean = 0.0;
    std::optional<BodySide> m_bump;
    int m_back = 0;  ///< in which direction it backs out: -1 backwards, 1 forwards, 0 not at all
    int m_last = 0;  ///< m_back of the previous evasion
    int m_times = 0;
    Eigen::Vector2d m_from = Eigen::Vector2d::Zero();  ///< where it began, in odom [m]
    Time m_since{};
    std::optional<Time> m_ended;
    std::string m_reason;
};

}  // namespace leitstand
