#pragma once

#include <memory>
#include <set>
#include <string>

#include "core/station/pad/pad_state.h"

// As SDL names them.
struct _SDL_GameController;
struct _SDL_Joystick;

namespace leitstand {

/// A gamepad that is plugged in.
struct PadInfo {
    int id = -1;       ///< new whenever a pad is plugged in
    std::string name;  ///< its name in SDL
    std::string guid;  ///< of its model: letters and digits
    PadLayout layout = PadLayout::Plain;
};

/// An open gamepad of SDL. Used on the pads' thread alone.
class SdlDevice {
public:
    /// Opens the joystick that SDL has at @p index now. Null when it cannot be opened (SDL_GetError() has the
    /// reason).
    [[nodiscard]] static std::unique_ptr<SdlDevice> open(int index);
    SdlDevice(const SdlDevice&) = delete;
    SdlDevice& operator=(const SdlDevice&) = delete;
    ~SdlDevice();

    [[nodiscard]] const PadInfo& info() const { return m_info; }
    [[nodiscard]] bool attached() const;
    /// Returns the state that SDL received last.
    [[nodiscard]] PadState read() const;
    /// Notes that @p button, numbered as in layout @p of, went down since the last read(). It may be up again
    /// already. Ignored when @p of is not this pad's layout.
    void pressed(PadLayout of, int button);
    /// Returns the buttons that pressed() noted since the last call.
    [[nodiscard]] std::set<int> takePressed();
    /// Rumbles the pad for @p milliseconds, @p strength 0 to 1. Does nothing on pads that cannot rumble.
    void rumble(double strength, int milliseconds);

private:
    SdlDevice() = default;
    [[nodiscard]] PadState readStandard() const;
    [[nodiscard]] PadState readPlain() const;

    PadInfo m_info;
    _SDL_GameController* m_controller = nullptr;  ///< of a pad that SDL knows, else null
    _SDL_Joystick* m_joystick = nullptr;          ///< the controller's, or our own
    std::set<int> m_pressed;
};

}  // namespace leitstand
