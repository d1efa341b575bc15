#pragma once

#include <functional>
#include <memory>
#include <string>

#include "app/window/live/pad/sdl_device.h"
#include "core/station/pad/pad_state.h"

namespace leitstand {

/// Callbacks on gamepads. They run on the pads' own thread and must not block it. Any may be empty.
struct PadListener {
    std::function<void(const PadInfo&)> onCame = {};
    std::function<void(int id, const PadState&)> onState = {};  ///< on every change, and at 20 Hz
    std::function<void(int id)> onGone = {};
    std::function<void(const std::string&)> onTrouble = {};  ///< for the operator, in English
};

/// Watches all plugged-in gamepads with SDL (no windows, no video), on its own thread, whatever window has
/// the focus. Reads them at 200 Hz; looks for new ones at 10 Hz while none is plugged in. Reports a button as
/// held even when it went down and up between two looks.
class SdlPads {
public:
    explicit SdlPads(PadListener listener);
    ~SdlPads();
    SdlPads(const SdlPads&) = delete;
    SdlPads& operator=(const SdlPads&) = delete;

    /// Rumbles the pad @p id for @p milliseconds, @p strength 0 to 1. Any thread; returns at once.
    void rumble(int id, double strength, int milliseconds);

private:
    struct State;
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand
