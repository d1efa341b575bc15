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
    double backFrom = 0.5;  ///< it backs out when it leans beyond this share of what tips it over
    double slowFrom = 0.2;  ///< from this share on it is slower
    double slowest = 0.4;   ///< share of its speed that is left at backFrom
    double speed = 0.12;    ///< while it backs out [m/s]
    double way = 0.35;      ///< so far [m]
    double within = 5.0;    ///< ... or so long [s]
    double apart = 4.0;     ///< what is felt sooner after the last time belongs to that [s]
    int most = 5;           ///< times that it tries one after another
};

/// Sides of a robot.
enum class BodySide : std::uint8_t { Front, Left, Rear, Right };

/// One step of it.
struct EvasionStep {
    std::optional<DriveVelocity> velocity;  ///< to be driven instead of what the driver wants
    std::optional<BodySide> felt;           ///< something was felt just now, there
    bool touched = false;                   ///< ... and it ran against it: else it leant
    bool failed = false;                    ///< it finds no way off
    std::string reason;                     ///< in words
};

/// Backs out of what the scanner does not see: low things that the robot runs against, and ground that makes
/// it lean too much (paper, section 3: the Crawler). Pure: times are passed in.
class Evasion {
public:
    explicit Evasion(const EvasionSettings& settings = {}) : m_settings(settings) {}

    /// How far it leans, as a share of what tips it over.
    void lean(double share) { m_lean = share; }
    void bumped(BodySide side) { m_bump = side; }
    /// Forgets what it was about: others drive.
    void reset();

    /// @p wanted: what the driver wanted last. To be called 10 times a second or more.
    [[nodiscard]] EvasionStep step(const DriveVelocity& wanted, const Pose& baseInOdom, Time now);
    /// Share of the speed that its leaning leaves.
    [[nodiscard]] double caution() const;
    [[nodiscard]] bool isActive() const { return m_back != 0; }

private:
    void begin(int back, const Pose& baseInOdom, Time now, const std::string& reason);

    EvasionSettings m_settings;
    double m_lean = 0.0;
    std::optional<BodySide> m_bump;
    int m_back = 0;  ///< which way it drives now: -1 backwards, 1 forwards, 0 not at all
    int m_last = 0;  ///< of the time before
    int m_times = 0;
    Eigen::Vector2d m_from = Eigen::Vector2d::Zero();  ///< in odom [m]
    Time m_since{};
    std::optional<Time> m_ended;
    std::string m_reason;
};

}  // namespace leitstand
