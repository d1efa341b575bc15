#include "tests/app/pad/virtual_pad.h"

#include <algorithm>
#include <stdexcept>

#define SDL_MAIN_HANDLED
#include <SDL2/SDL.h>

namespace leitstand::test {

VirtualPad::VirtualPad(PadLayout layout, const std::string& name,
                       const std::vector<std::pair<int, double>>& held)
    : m_layout(layout), m_name(name) {
    if (SDL_InitSubSystem(SDL_INIT_JOYSTICK | SDL_INIT_GAMECONTROLLER) != 0)
        throw std::runtime_error(SDL_GetError());
    const bool known = layout == PadLayout::Standard;
    SDL_VirtualJoystickDesc description{};
    description.version = SDL_VIRTUAL_JOYSTICK_DESC_VERSION;
    description.type =
        static_cast<Uint16>(known ? SDL_JOYSTICK_TYPE_GAMECONTROLLER : SDL_JOYSTICK_TYPE_FLIGHT_STICK);
    description.naxes = known ? standard_axis::Count : 4;
    description.nbuttons = known ? standard_button::Count : 8;
    description.nhats = known ? 0 : 1;
    description.name = m_name.c_str();
    description.userdata = this;
    description.Rumble = &VirtualPad::shaken;
    SDL_LockJoysticks();
    const int index = SDL_JoystickAttachVirtualEx(&description);
    m_joystick = index < 0 ? nullptr : SDL_JoystickOpen(index);
    if (m_joystick != nullptr) m_id = SDL_JoystickInstanceID(m_joystick);
    if (m_joystick != nullptr && known) {
        push(standard_axis::LeftTrigger, 0.0);
        push(standard_axis::RightTrigger, 0.0);
    }
    for (const auto& [axis, value] : held) {
        if (m_joystick != nullptr) push(axis, value);
    }
    SDL_UnlockJoysticks();
    if (m_joystick == nullptr) throw std::runtime_error(SDL_GetError());
}

VirtualPad::~VirtualPad() {
    SDL_LockJoysticks();
    for (int index = SDL_NumJoysticks() - 1; index >= 0; --index) {
        if (SDL_JoystickGetDeviceInstanceID(index) == m_id) SDL_JoystickDetachVirtual(index);
    }
    SDL_JoystickClose(m_joystick);
    SDL_UnlockJoysticks();
    SDL_QuitSubSystem(SDL_INIT_JOYSTICK | SDL_INIT_GAMECONTROLLER);
}

int VirtualPad::shaken(void* pad, unsigned short low, unsigned short high) {
    if (low > 0 || high > 0) ++static_cast<VirtualPad*>(pad)->m_rumbles;
    return 0;
}

void VirtualPad::push(int axis, double value) {
    const bool trigger = m_layout == PadLayout::Standard && axis >= standard_axis::LeftTrigger;
    const double raw = 32'767.0 * (trigger ? 2.0 * value - 1.0 : value);
    SDL_JoystickSetVirtualAxis(m_joystick, axis, static_cast<Sint16>(std::clamp(raw, -32'768.0, 32'767.0)));
}

void VirtualPad::press(int button, bool held) {
    SDL_JoystickSetVirtualButton(m_joystick, button, held ? 1 : 0);
}

void VirtualPad::hat(int directions) {
    SDL_JoystickSetVirtualHat(m_joystick, 0, static_cast<Uint8>(directions));
}

}  // namespace leitstand::test
