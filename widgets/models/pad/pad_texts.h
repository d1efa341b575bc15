#pragma once

#include <string>
#include <vector>

#include <QString>

#include "core/station/pad/pad_bindings.h"

namespace leitstand {

/// A command of the window that a pad can trigger.
struct PadCommandFace {
    std::string id;  ///< "camera.recentre"
    QString text;    ///< "Re-centre cameras"
    QString hint;
};

[[nodiscard]] QString padActionName(PadAction action);  ///< "Turn left"
[[nodiscard]] QString padActionHint(PadAction action);
/// "Left stick up", "Left trigger"; for an unknown joystick "Axis 3 +", "Button 7", counted from 1. A dash
/// for no control.
[[nodiscard]] QString padControlName(const PadControl& control, PadLayout layout);
/// Returns what the operator must do so that the pad drives: first hold the trigger, then push the stick. If
/// no control is bound to that trigger, says so.
[[nodiscard]] QString padDriveHint(const PadBindings& bindings);
/// Returns how to connect a gamepad, and which pads are known.
[[nodiscard]] QString padConnectHelp();
/// Returns the keys that drive without a gamepad.
[[nodiscard]] QString padlessKeys();

}  // namespace leitstand
