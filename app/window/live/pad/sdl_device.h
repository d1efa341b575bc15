#pragma once

#include <memory>
#include <set>
#include <string>

#include "core/station/pad/pad_state.h"

// As SDL names them.
struct _SDL_GameController;
struct _SDL_Joystick;

namespace leitstand {

/// A gamepad as it is plugged in.
struct PadInfo {
    int id = -1;       ///< of this plugging in; another one has another
    std::string name;  ///< as it calls itself
    std::string guid;  ///< of its kind: letters and digits
    PadLayout layout = PadLayout::Plain;
};

/// An open gamepad of SDL's. Of the pads' thread alone.
class SdlDevice {
public:
    /// The joystick that SDL has at @p index now; null when it cannot be opened (SDL_GetError tells why).
    [[nodiscard]] static std::unique_ptr<SdlDevice> open(int index);
    SdlDevice(const SdlDevice&) = delete;
    SdlDevice& operator=(const SdlDevice&) = delete;
    ~SdlDevice();

    [[nodiscard]] const PadInfo& info() const { return m_info; }
    [[nodiscard]] bool attached() const;
    /// As SDL was told last.
    [[nodiscard]] PadState read() const;
    /// A button came down since the state was read, as one of the layout @p of; it may be up again already.
    void pressed(PadLayout of, int button);
    /// The buttons that came down since this was asked last.
    [[nodiscard]] std::set<int> takePressed();
    /// @p strength 0 to 1. Pads that cannot do nothing.
    void rumble(double strength, int milliseconds);

private:
    SdlDevice() = default;
    [[nodiscard]] PadState readStandard() const;
    [[nodiscard]] PadState readPlain() const;

    PadInfo m_info;
    _SDL_GameController* m_controller = nullptr;  ///< of a known pad
    _SDL_Joystick* m_joystick = nullptr;          ///< the controller's, or our own
    std::set<int> m_pressed;
};

}  // namespace leitstand
