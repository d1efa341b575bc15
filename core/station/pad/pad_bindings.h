#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/station/pad/pad_state.h"

namespace leitstand {

/// What a control of a gamepad can do. Two opposite actions are the two ends of a stick, or two buttons.
enum class PadAction : std::uint8_t {
    DeadMan,  ///< the robot only moves while it is held
    Forward,
    Back,
    TurnLeft,
    TurnRight,
    SlideLeft,  ///< for omnidirectional robots
    SlideRight,
    Turbo,
    Slow,
    Stop,  ///< stops all robots
    PanLeft,
    PanRight,
    TiltUp,
    TiltDown,
    WithoutEyes  ///< while it is held, old pictures do not limit the speed
};
inline constexpr std::size_t PadActionCount = 15;
[[nodiscard]] std::array<PadAction, PadActionCount> padActions();
/// Returns the name of an action in files: "turn_left".
[[nodiscard]] std::string toString(PadAction action);
/// Returns the opposite, such as Forward for Back; empty when there is none.
[[nodiscard]] std::optional<PadAction> oppositeOf(PadAction action);

/// One way to push one control: a button, or an axis from its rest towards one end.
struct PadControl {
    enum class Kind : std::uint8_t { None, Axis, Button };
    Kind kind = Kind::None;
    int index = 0;
    bool negative = false;  ///< for an axis: whether it is pushed towards -1
    double rest = 0.0;      ///< for an axis: its value when nobody touches it; -1 or 1 for some triggers
    friend bool operator==(const PadControl&, const PadControl&) = default;
};
[[nodiscard]] PadControl padButton(int index);
/// @p towards: end towards which the axis @p index is pushed, -1 or 1. @p rest: see PadControl::rest.
[[nodiscard]] PadControl padAxis(int index, int towards, double rest = 0.0);
/// Returns the other end of a stick; Kind::None for triggers and buttons.
[[nodiscard]] PadControl oppositeOf(const PadControl& control);
/// Returns how far @p control is pushed, 0 to 1.
[[nodiscard]] double amountOf(const PadControl& control, const PadState& state);

/// A command of the window that is bound to a control.
struct PadCommand {
    std::string id;  ///< id of the command, "camera.recentre"
    PadControl control;
    friend bool operator==(const PadCommand&, const PadCommand&) = default;
};

/// Which control of a pad does what.
struct PadBindings {
    static constexpr double MostDeadZone = 0.6, LeastPress = 0.1, MostPress = 0.95, MostRate = 6.3;
    static constexpr std::size_t MostCommands = 64;
    static constexpr int MostControls = 128;  ///< indices of axes and buttons are below this

    PadLayout layout = PadLayout::Standard;
    std::array<PadControl, PadActionCount> controls{};
    std::vector<PadCommand> commands;
    double deadZone = 0.12;   ///< for sticks: share around the rest that is treated as zero
    double expo = 0.4;        ///< 0: sticks are linear; 1: they are cubic, finer around the rest
    double press = 0.5;       ///< share from which an axis is pressed
    double cameraRate = 1.2;  ///< turn rate of pan and tilt at the end of the stick [rad/s]

    [[nodiscard]] const PadControl& at(PadAction action) const {
        return controls[static_cast<std::size_t>(action)];
    }
    [[nodiscard]] PadControl& at(PadAction action) { return controls[static_cast<std::size_t>(action)]; }
    friend bool operator==(const PadBindings&, const PadBindings&) = default;
};

/// Returns the position of the stick between @p plus (1) and its opposite action (-1), without dead zone and
/// expo. @p plus must have an opposite.
[[nodiscard]] double deflectionOf(const PadBindings& bindings, PadAction plus, const PadState& state);
/// Returns the same as deflectionOf(), with dead zone and expo applied.
[[nodiscard]] double shapedOf(const PadBindings& bindings, PadAction plus, const PadState& state);

/// Returns the default bindings of a known pad. Other joysticks have none, so that nothing moves
/// unexpectedly. Left trigger: dead-man; right trigger: turbo. Right shoulder: slow; left shoulder: drives
/// without eyes. Left stick: drives; right stick: turns cameras. B stops all, X files a victim, A confirms
/// it, the cross fills in its form. Left stick pressed: the right one moves joints; Start: the next of them.
[[nodiscard]] PadBindings defaultBindings(PadLayout layout);

/// Binds @p action to @p control, and the opposite action to the other end of a stick. Earlier bindings of
/// these controls are removed. Returns false without a change if that would remove the control that stops all
/// robots.
[[nodiscard]] bool bindPad(PadBindings& bindings, PadAction action, const PadControl& control);
/// Binds the command with the id @p id to @p control in the same way. Kind::None removes the command from the
/// pad.
[[nodiscard]] bool bindPad(PadBindings& bindings, const std::string& id, const PadControl& control);

/// Returns the control of the command @p id; Kind::None if there is none.
[[nodiscard]] PadControl controlOf(const PadBindings& bindings, const std::string& id);

}  // namespace leitstand
