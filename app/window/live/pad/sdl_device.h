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
    int id = -1;       ///< a new id each time that a pad is plugged in
    std::string name;  ///< its name in SDL
    std::string guid;  ///< of the pad's model: letters and digits
    PadLayout layout = PadLayout::Plain;
};

/// A gamepad that is open in SDL. Used only on the pads' thread.
class SdlDevice {
public:
    /// Opens the joystick that SDL now has at @p index. Null: it cannot be opened (SDL_GetError() says why).
    [[nodiscard]] static std::unique_ptr<SdlDevice> open(int index);
    SdlDevice(const SdlDevice&) = delete;
    SdlDevice& operator=(const SdlDevice&) = delete;
    ~SdlDevice();

    [[nodiscard]] const PadInfo& info() const { return m_info; }
    [[nodiscard]] bool attached() const;
    /// Returns the last state that SDL received.
    [[nodiscard]] PadState read() const;
    /// Notes that @p button, numbered as in layout @p of, was pressed since the last read(). It may already
    /// be released again. Ignored if @p of is not this pad's layout.
    void pressed(PadLayout of, int button);
    /// Returns the buttons that pressed() noted since the last call.
    [[nodiscard]] std::set<int> takePressed();
    /// Rumbles the pad for @p milliseconds, with @p strength from 0 to 1. Does nothing on pads that cannot
    /// rumble.
    void rumble(double strength, int milliseconds);

private:
    SdlDevice() = default;
    [[nodiscard]] PadState readStandard() const;
    [[nodiscard]] PadState readPlain() const;

    PadInfo m_info;
    _SDL_GameController* m_controller = nullptr;  ///< for a pad that SDL knows; otherwise null
    _SDL_Joystick* m_joystick = nullptr;          ///< the controller's joystick, or our own
    std::set<int> m_pressed;
};

}  // namespace leitstand
