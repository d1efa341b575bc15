#pragma once

#include <functional>
#include <memory>
#include <string>

#include "app/window/live/pad/sdl_device.h"
#include "core/station/pad/pad_state.h"

namespace leitstand {

/// Callbacks about gamepads. They run on the pads' own thread and must not block it. Each may be empty.
struct PadListener {
    std::function<void(const PadInfo&)> onCame = {};
    std::function<void(int id, const PadState&)> onState = {};  ///< called at every change, and at 20 Hz
    std::function<void(int id)> onGone = {};
    std::function<void(const std::string&)> onTrouble = {};  ///< called with an English text for the operator
};

/// Reads all gamepads that are plugged in with SDL (no windows, no video), on its own thread, whatever window
/// has the focus. Reads them at 200 Hz. If none is plugged in, looks for new ones at 10 Hz. Reports a button
/// as held even if it was pressed and released between two reads.
class SdlPads {
public:
    explicit SdlPads(PadListener listener);
    ~SdlPads();
    SdlPads(const SdlPads&) = delete;
    SdlPads& operator=(const SdlPads&) = delete;

    /// Rumbles the pad @p id for @p milliseconds, with @p strength from 0 to 1. Any thread; returns at once.
    void rumble(int id, double strength, int milliseconds);

private:
    struct State;
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand
