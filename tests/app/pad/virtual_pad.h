#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/station/pad/pad_state.h"

struct _SDL_Joystick;

namespace leitstand::test {

/// A gamepad that only SDL has, plugged in as long as it lives: the program under test cannot tell it from a
/// real one.
class VirtualPad {
public:
    /// Standard: a known pad, its controls at rest. Plain: a joystick of four axes, eight buttons and a hat.
    /// @p held: axes that are pushed when it is plugged in, and how far.
    explicit VirtualPad(PadLayout layout = PadLayout::Standard, const std::string& name = "Test pad",
                        const std::vector<std::pair<int, double>>& held = {});
    ~VirtualPad();  ///< unplugs it
    VirtualPad(const VirtualPad&) = delete;
    VirtualPad& operator=(const VirtualPad&) = delete;

    /// @p value -1 to 1; of a known pad's trigger 0 to 1.
    void push(int axis, double value);
    void press(int button, bool held = true);
    void hat(int directions);  ///< of SDL's SDL_HAT_UP and so on
    [[nodiscard]] int rumbles() const { return m_rumbles; }

private:
    static int shaken(void* pad, unsigned short low, unsigned short high);

    PadLayout m_layout;
    std::string m_name;
    _SDL_Joystick* m_joystick = nullptr;
    int m_id = -1;
    int m_rumbles = 0;
};

}  // namespace leitstand::test
