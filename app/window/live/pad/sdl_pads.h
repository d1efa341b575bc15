#pragma once

#include <functional>
#include <memory>
#include <string>

#include "app/window/live/pad/sdl_device.h"
#include "core/station/pad/pad_state.h"

namespace leitstand {

/// Who is told of gamepads, on the pads' own thread, which must not be held up. Any may be empty.
struct PadListener {
    std::function<void(const PadInfo&)> onCame = {};
    std::function<void(int id, const PadState&)> onState = {};  ///< when it changed, and 20 times a second
    std::function<void(int id)> onGone = {};
    std::function<void(const std::string&)> onTrouble = {};  ///< for the operator, in English
};

/// All gamepads that are plugged in, by SDL (no windows, no video), watched two hundred times a second on a
/// thread of its own, whatever window has the focus. Ten looks a second for new ones while there are none. A
/// button that was down and up between two looks is told as held nevertheless.
class SdlPads {
public:
    explicit SdlPads(PadListener listener);
    ~SdlPads();
    SdlPads(const SdlPads&) = delete;
    SdlPads& operator=(const SdlPads&) = delete;

    /// Lets the pad @p id tremble, @p strength 0 to 1. Any thread, at once back.
    void rumble(int id, double strength, int milliseconds);

private:
    struct State;
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand
