#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace leitstand {

/// How the controls of a gamepad are numbered.
enum class PadLayout : std::uint8_t {
    Standard,  ///< a known pad: as in standard_axis and standard_button, whatever its manufacturer calls them
    /// Any joystick: in the numbers of its driver, with four buttons for each hat after its own buttons.
    Plain
};

/// Axes of a known pad. Sticks: -1 to 1, right and down positive; triggers: 0 to 1.
namespace standard_axis {
inline constexpr int LeftX = 0, LeftY = 1, RightX = 2, RightY = 3, LeftTrigger = 4, RightTrigger = 5;
inline constexpr int Count = 6;
}  // namespace standard_axis

/// Buttons of a known pad, named as on an Xbox pad.
namespace standard_button {
inline constexpr int A = 0, B = 1, X = 2, Y = 3, Back = 4, Guide = 5, Start = 6, LeftStick = 7,
                     RightStick = 8, LeftShoulder = 9, RightShoulder = 10, Up = 11, Down = 12, Left = 13,
                     Right = 14;
inline constexpr int Count = 15;
}  // namespace standard_button

/// The state of a gamepad at one moment.
struct PadState {
    bool connected = false;
    std::vector<double> axes = {};   ///< -1 to 1
    std::vector<bool> buttons = {};  ///< whether each button is held

    [[nodiscard]] double axis(int index) const {
        const auto i = static_cast<std::size_t>(index);
        return index >= 0 && i < axes.size() ? axes[i] : 0.0;
    }
    [[nodiscard]] bool button(int index) const {
        const auto i = static_cast<std::size_t>(index);
        return index >= 0 && i < buttons.size() && buttons[i];
    }
    friend bool operator==(const PadState&, const PadState&) = default;
};

}  // namespace leitstand
