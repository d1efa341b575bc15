#include "app/window/live/pad/sdl_device.h"

#include <algorithm>
#include <array>
#include <utility>

#define SDL_MAIN_HANDLED
#include <SDL2/SDL.h>

namespace leitstand {
namespace {

constexpr double AxisEnd = 32'767.0;

double share(Sint16 value) {
    return std::max(-1.0, static_cast<double>(value) / AxisEnd);
}

std::string textOf(const char* text) {
    return text == nullptr ? std::string() : text;
}

// Core numbers controls of a known pad as SDL does.
static_assert(static_cast<int>(SDL_CONTROLLER_AXIS_TRIGGERLEFT) == standard_axis::LeftTrigger);
static_assert(static_cast<int>(SDL_CONTROLLER_AXIS_MAX) == standard_axis::Count);
static_assert(static_cast<int>(SDL_CONTROLLER_BUTTON_B) == standard_button::B);
static_assert(static_cast<int>(SDL_CONTROLLER_BUTTON_DPAD_RIGHT) == standard_button::Right);

}  // namespace

std::unique_ptr<SdlDevice> SdlDevice::open(int index) {
    std::unique_ptr<SdlDevice> device(new SdlDevice);
    if (SDL_IsGameController(index) == SDL_TRUE) {
        device->m_controller = SDL_GameControllerOpen(index);
        if (device->m_controller == nullptr) return nullptr;
        device->m_joystick = SDL_GameControllerGetJoystick(device->m_controller);
        device->m_info.layout = PadLayout::Standard;
        device->m_info.name = textOf(SDL_GameControllerName(device->m_controller));
    } else {
        device->m_joystick = SDL_JoystickOpen(index);
        if (device->m_joystick == nullptr) return nullptr;
        device->m_info.name = textOf(SDL_JoystickName(device->m_joystick));
    }
    device->m_info.id = SDL_JoystickInstanceID(device->m_joystick);
    std::array<char, 40> guid{};
    SDL_JoystickGetGUIDString(SDL_JoystickGetGUID(device->m_joystick), guid.data(),
                              static_cast<int>(guid.size()));
    device->m_info.guid = guid.data();
    return device;
}

SdlDevice::~SdlDevice() {
    if (m_controller != nullptr) {
        SDL_GameControllerClose(m_controller);
    } else if (m_joystick != nullptr) {
        SDL_JoystickClose(m_joystick);
    }
}

bool SdlDevice::attached() const {
    return SDL_JoystickGetAttached(m_joystick) == SDL_TRUE;
}

PadState SdlDevice::readStandard() const {
    PadState state{.connected = true};
    for (int i = 0; i < standard_axis::Count; ++i) {
        state.axes.push_back(
            share(SDL_GameControllerGetAxis(m_controller, static_cast<SDL_GameControllerAxis>(i))));
    }
    for (int i = 0; i < standard_button::Count; ++i) {
        state.buttons.push_back(
            SDL_GameControllerGetButton(m_controller, static_cast<SDL_GameControllerButton>(i)) != 0);
    }
    return state;
}

PadState SdlDevice::readPlain() const {
    PadState state{.connected = true};
    for (int i = 0; i < SDL_JoystickNumAxes(m_joystick); ++i)
        state.axes.push_back(share(SDL_JoystickGetAxis(m_joystick, i)));
    for (int i = 0; i < SDL_JoystickNumButtons(m_joystick); ++i)
        state.buttons.push_back(SDL_JoystickGetButton(m_joystick, i) != 0);
    for (int i = 0; i < SDL_JoystickNumHats(m_joystick); ++i) {
        const int hat = SDL_JoystickGetHat(m_joystick, i);
        for (const int direction : {SDL_HAT_UP, SDL_HAT_DOWN, SDL_HAT_LEFT, SDL_HAT_RIGHT})
            state.buttons.push_back((hat & direction) != 0);
    }
    return state;
}

PadState SdlDevice::read() const {
    return m_controller != nullptr ? readStandard() : readPlain();
}

void SdlDevice::pressed(PadLayout of, int button) {
    if (of == m_info.layout) m_pressed.insert(button);
}

std::set<int> SdlDevice::takePressed() {
    return std::exchange(m_pressed, {});
}

void SdlDevice::rumble(double strength, int milliseconds) {
    const auto force = static_cast<Uint16>(65'535.0 * std::clamp(strength, 0.0, 1.0));
    SDL_JoystickRumble(m_joystick, force, force, static_cast<Uint32>(std::max(0, milliseconds)));
}

}  // namespace leitstand
