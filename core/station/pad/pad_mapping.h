#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/robot/control/drive_setpoint.h"
#include "core/station/pad/pad_bindings.h"

namespace leitstand {

/// Requested turn rates of the cameras.
struct PanTiltRate {
    double pan = 0.0;   ///< rate to the left [rad/s]
    double tilt = 0.0;  ///< rate upwards [rad/s]
    friend bool operator==(const PanTiltRate&, const PanTiltRate&) = default;
};

/// What the operator requests with a gamepad.
struct PadRequests {
    DriveVelocity drive;                ///< zero unless `driving`
    bool driving = false;               ///< the dead-man trigger is held and accepted: this pad drives
    bool withoutEyes = false;           ///< while driving: old pictures do not limit the speed
    bool needsNeutral = false;          ///< the trigger is held, but trigger or sticks must be released first
    PanTiltRate cameras;                ///< needs no trigger, since turning cameras is harmless
    double joints = 0.0;                ///< while driving: share for joints, up positive (stick of TiltUp)
    bool stop = false;                  ///< the button that stops all robots was pressed
    std::vector<std::string> commands;  ///< commands whose controls were pressed
    friend bool operator==(const PadRequests&, const PadRequests&) = default;
};

/// What a gamepad may do now.
enum class PadScope {
    Nothing,   ///< nothing: the operator uses another window
    Commands,  ///< the robot is stopped: only commands that file, look or select
    All,       ///< everything, including driving and turning cameras
};

/// Converts the state of a gamepad to what the operator requests (docs/design.md, "The window"). Pure.
///
/// Nothing drives without the dead-man trigger; releasing it means zero at once. The sticks are accepted only
/// after they were neutral while the trigger was held, so that motion begins with the operator's hand. The
/// trigger must first be released after the pad was connected, and after each loss of PadScope::All (another
/// window, a stop, another robot). Stop needs none of this.
class PadMapping {
public:
    explicit PadMapping(PadBindings bindings = {});

    void setBindings(PadBindings bindings);  ///< afterwards, trigger and sticks must first be released
    [[nodiscard]] const PadBindings& bindings() const { return m_bindings; }
    void setLimits(const DriveLimits& limits) { m_limits = limits; }
    void needNeutral();  ///< requires trigger and sticks to be released first

    /// Returns the requests of the pad in @p state. Call it at every change of the pad.
    [[nodiscard]] PadRequests update(const PadState& state, PadScope scope);

private:
    [[nodiscard]] bool isHeld(const PadControl& control, const PadState& state, bool before) const;
    [[nodiscard]] bool held(PadAction action) const { return m_held[static_cast<std::size_t>(action)]; }
    void readCommands(const PadState& state, PadScope scope, PadRequests& requests);
    void readDrive(const PadState& state, PadRequests& requests);
    void readCameras(const PadState& state, PadRequests& requests);

    PadBindings m_bindings;
    DriveLimits m_limits;
    std::array<bool, PadActionCount> m_held{};
    std::vector<bool> m_commandHeld;  ///< whether the control of each m_bindings.commands is held
    bool m_known = false;             ///< whether the pad was read since it was connected
    bool m_triggerFree = false;       ///< whether the trigger was released since that was required
    bool m_sticksFree = false;        ///< whether the sticks were neutral while the trigger was held
    bool m_jointsFree = false;   ///< whether that stick was neutral while the trigger was held and accepted
    bool m_camerasFree = false;  ///< whether the stick of the cameras was neutral since that was required
};

}  // namespace leitstand
