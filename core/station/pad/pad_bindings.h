#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/station/pad/pad_state.h"

namespace leitstand {

/// What a control of a gamepad can do. Two that are opposite are the two ends of one stick, or two buttons.
enum class PadAction : std::uint8_t {
    DeadMan,  ///< the robot moves only while it is held
    Forward,
    Back,
    TurnLeft,
    TurnRight,
    SlideLeft,  ///< omnidirectional robots
    SlideRight,
    Turbo,
    Slow,
    Stop,  ///< all robots
    PanLeft,
    PanRight,
    TiltUp,
    TiltDown,
    WithoutEyes  ///< while it is held, old pictures do not cap the speed
};
inline constexpr std::size_t PadActionCount = 15;
[[nodiscard]] std::array<PadAction, PadActionCount> padActions();
/// As in files: "turn_left".
[[nodiscard]] std::string toString(PadAction action);
/// Forward for Back and so on; nothing for those without.
[[nodiscard]] std::optional<PadAction> oppositeOf(PadAction action);

/// One way to push one control: a button, or an axis from its rest towards one of its ends.
struct PadControl {
    enum class Kind : std::uint8_t { None, Axis, Button };
    Kind kind = Kind::None;
    int index = 0;
    bool negative = false;  ///< of an axis: towards -1
    double rest = 0.0;      ///< of an axis: where it is when nobody touches it; -1 and 1 for some triggers
    friend bool operator==(const PadControl&, const PadControl&) = default;
};
[[nodiscard]] PadControl padButton(int index);
/// @p towards: -1 or 1.
[[nodiscard]] PadControl padAxis(int index, int towards, double rest = 0.0);
/// The other end of a stick; none for others.
[[nodiscard]] PadControl oppositeOf(const PadControl& control);
/// How far @p control is pushed, 0 to 1.
[[nodiscard]] double amountOf(const PadControl& control, const PadState& state);

/// A command of the window on a control.
struct PadCommand {
    std::string id;  ///< of the command, "camera.recentre"
    PadControl control;
    friend bool operator==(const PadCommand&, const PadCommand&) = default;
};

/// Which control of a pad does what.
struct PadBindings {
    static constexpr double MostDeadZone = 0.6, LeastPress = 0.1, MostPress = 0.95, MostRate = 6.3;
    static constexpr std::size_t MostCommands = 64;
    static constexpr int MostControls = 128;  ///< indices of axes and buttons are below

    PadLayout layout = PadLayout::Standard;
    std::array<PadControl, PadActionCount> controls{};
    std::vector<PadCommand> commands;
    double deadZone = 0.12;   ///< of sticks: share around the rest that is nothing
    double expo = 0.4;        ///< 0: sticks are linear, 1: cubic, finer around the rest
    double press = 0.5;       ///< share from which on an axis counts as pressed
    double cameraRate = 1.2;  ///< of pan and tilt at the end of the stick [rad/s]

    [[nodiscard]] const PadControl& at(PadAction action) const {
        return controls[static_cast<std::size_t>(action)];
    }
    [[nodiscard]] PadControl& at(PadAction action) { return controls[static_cast<std::size_t>(action)]; }
    friend bool operator==(const PadBindings&, const PadBindings&) = default;
};

/// Where the stick between @p plus and its opposite is, -1 to 1, as the hand holds it.
[[nodiscard]] double deflectionOf(const PadBindings& bindings, PadAction plus, const PadState& state);
/// The same as it counts, without dead zone and with expo.
[[nodiscard]] double shapedOf(const PadBindings& bindings, PadAction plus, const PadState& state);

/// Of a known pad: left trigger dead-man, right trigger turbo, right shoulder slow, left shoulder drives
/// without eyes, left stick drives, right stick turns cameras, B stops all, X files a victim, A confirms it,
/// the cross fills in its form. Of any other joystick: nothing, and so nothing moves.
[[nodiscard]] PadBindings defaultBindings(PadLayout layout);

/// Gives @p action to @p control, and to its other end the opposite action. Who had the control has none
/// then. False, and nothing is changed: it is the control that stops all.
[[nodiscard]] bool bindPad(PadBindings& bindings, PadAction action, const PadControl& control);
/// The same for the command @p id; of none, it is taken off the pad.
[[nodiscard]] bool bindPad(PadBindings& bindings, const std::string& id, const PadControl& control);

/// The control that does @p id; none when the pad does not.
[[nodiscard]] PadControl controlOf(const PadBindings& bindings, const std::string& id);

}  // namespace leitstand
