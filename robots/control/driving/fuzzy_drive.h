#pragma once

#include <optional>

#include "core/base/result.h"
#include "core/perception/surroundings/virtual_scan_view.h"
#include "core/robot/control/drive_setpoint.h"
#include "robots/control/fuzzy/fuzzy_system.h"
#include "robots/control/safe_teleoperation.h"

namespace leitstand {

/// How the fuzzy driver is adapted to a robot.
struct FuzzyDriveSettings {
    SafeTeleoperationSettings safety;  ///< the robot's body, and what the robot may never do
    double speed = 0.35;               ///< speed for the output "speed is 1" [m/s]
    double turnRate = 0.8;             ///< turn rate for the output "turn is 1" [rad/s]
    double sight = 3.0;                ///< everything farther away than this is treated as free [m]
};

/// One step of driving, and why.
struct FuzzyDriveStep {
    DriveVelocity velocity;
    FuzzyValues inputs;  ///< front, front_left ..., goal
    FuzzyResult result;
    std::string reason;  ///< English text: the strongest rule, or why the robot stands
};

/// Reactive fuzzy control (paper, section 2.3): steers into free space with the virtual scan, towards a
/// direction if there is one. The rules have inputs `front`, `front_left`, `left`, `front_right`, `right` and
/// `rear`: the free distance from the body's side [m]. Further inputs are `goal` (direction of the goal, left
/// positive [degrees]), `goal_free` (free distance towards it [m]), and `open` (direction of the widest free
/// space [degrees]). Outputs: `speed` and `turn`, -1 to 1.
class FuzzyDrive {
public:
    /// Errors name the inputs or outputs of @p system that are unknown.
    [[nodiscard]] static Result<FuzzyDrive> create(FuzzySystem system, const FuzzyDriveSettings& settings);

    /// @p goal: direction in base_link [rad]; empty: any free direction. @p share: share of the speed and
    /// turn rate, 0 to 1.
    [[nodiscard]] FuzzyDriveStep step(const VirtualScanView& view, std::optional<double> goal,
                                      double share = 1.0) const;
    [[nodiscard]] FuzzyValues inputsOf(const VirtualScanView& view, std::optional<double> goal) const;
    [[nodiscard]] const FuzzyDriveSettings& settings() const { return m_settings; }
    [[nodiscard]] const FuzzySystem& system() const { return m_system; }

private:
    FuzzyDrive(FuzzySystem system, const FuzzyDriveSettings& settings);
    FuzzySystem m_system;
    FuzzyDriveSettings m_settings;
};

}  // namespace leitstand
