#include "app/window/live/pad/sdl_pads.h"

#include <array>
#include <chrono>
#include <condition_variable>
#include <map>
#include <mutex>
#include <set>
#include <thread>
#include <utility>
#include <vector>

#define SDL_MAIN_HANDLED
#include <SDL2/SDL.h>
#include <pthread.h>

#include "core/base/words.h"

namespace leitstand {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds Look(5), LookForNew(100);
constexpr std::chrono::milliseconds Repeat(50);  ///< interval of reports while a state does not change

}  // namespace

struct SdlPads::State {
    struct Pad {
        bool fresh = true;  ///< SDL has not read its controls yet: its state means nothing
        std::unique_ptr<SdlDevice> device;
        PadState reported;
        Clock::time_point at{};
    };
    struct Rumble {
        int id;
        double strength;
        int milliseconds;
    };

    void run(const std::stop_token& stop);
    void lookForNew();
    void takeEvents();
    void publish(Pad& pad);
    void shake();
    void pressed(PadLayout layout, int id, int button) {
        const auto found = pads.find(id);
        if (found != pads.end()) found->second.device->pressed(layout, button);
    }

    PadListener listener;
    std::mutex mutex;
    std::condition_variable_any woken;
    std::vector<Rumble> rumbles;  ///< guarded by mutex
    // Used by the thread alone:
    std::map<int, Pad> pads;
    std::set<int> refused;
    std::jthread thread;  ///< last: joined first
};

void SdlPads::State::lookForNew() {
    for (int index = 0; index < SDL_NumJoysticks(); ++index) {
        const int id = SDL_JoystickGetDeviceInstanceID(index);
        if (id < 0 || pads.contains(id) || refused.contains(id)) continue;
        auto device = SdlDevice::open(index);
        if (device == nullptr) {
            refused.insert(id);
            const char* const name = SDL_JoystickNameForIndex(index);
            if (listener.onTrouble) {
                listener.onTrouble(
                    leitstand::fill(translate("leitstand::Error", "The gamepad {} cannot be used: {}"),
                                    name == nullptr ? "" : name, SDL_GetError()));
            }
            continue;
        }
        if (listener.onCame) listener.onCame(device->info());
        pads[id].device = std::move(device);
    }
}

void SdlPads::State::takeEvents() {
    std::array<SDL_Event, 64> events;
    int count = 0;
    while ((count = SDL_PeepEvents(events.data(), static_cast<int>(events.size()), SDL_GETEVENT,
                                   SDL_FIRSTEVENT, SDL_LASTEVENT)) > 0) {
        for (int i = 0; i < count; ++i) {
            const SDL_Event& event = events[static_cast<std::size_t>(i)];
            if (event.type == SDL_JOYBUTTONDOWN)
                pressed(PadLayout::Plain, event.jbutton.which, event.jbutton.button);
            if (event.type == SDL_CONTROLLERBUTTONDOWN)
                pressed(PadLayout::Standard, event.cbutton.which, event.cbutton.button);
        }
    }
}

void SdlPads::State::publish(Pad& pad) {
    PadState now = pad.device->read();
    PadState tapped = now;
    for (const int button : pad.device->takePressed()) {
        const auto i = static_cast<std::size_t>(button);
        if (i < tapped.buttons.size() && !pad.reported.button(button)) tapped.buttons[i] = true;
    }
    const int id = pad.device->info().id;
    if (tapped != now && listener.onState) listener.onState(id, tapped);
    const auto at = Clock::now();
    if (tapped == now && now == pad.reported && at - pad.at < Repeat) return;
    pad.reported = std::move(now);
    pad.at = at;
    if (listener.onState) listener.onState(id, pad.reported);
}

void SdlPads::State::shake() {
    std::vector<Rumble> wanted;
    {
        const std::lock_guard lock(mutex);
        wanted.swap(rumbles);
    }
    for (const Rumble& one : wanted) {
        const auto found = pads.find(one.id);
        if (found != pads.end()) found->second.device->rumble(one.strength, one.milliseconds);
    }
}

void SdlPads::State::run(const std::stop_token& stop) {
    pthread_setname_np(pthread_self(), "pads");
    SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
    // STOP works whatever has the focus.
    SDL_SetHint(SDL_HINT_JOYSTICK_ALLOW_BACKGROUND_EVENTS, "1");
    if (SDL_InitSubSystem(SDL_INIT_JOYSTICK | SDL_INIT_GAMECONTROLLER) != 0) {
        if (listener.onTrouble)
            listener.onTrouble(leitstand::fill(translate("leitstand::Error", "Gamepads cannot be used: {}"),
                                               SDL_GetError()));
        return;
    }
    while (!stop.stop_requested()) {
        SDL_JoystickUpdate();
        takeEvents();
        std::erase_if(pads, [this](const auto& one) {
            const bool gone = !one.second.device->attached();
            if (gone && listener.onGone) listener.onGone(one.first);
            return gone;
        });
        SDL_LockJoysticks();  // indices stay valid
        lookForNew();
        SDL_UnlockJoysticks();
        // A trigger that is held while its pad is plugged in must not look as if it was released before.
        for (auto& [id, pad] : pads) {
            if (!std::exchange(pad.fresh, false)) publish(pad);
        }
        shake();
        std::unique_lock lock(mutex);
        woken.wait_for(lock, stop, pads.empty() ? LookForNew : Look, [] { return false; });
    }
    pads.clear();
    SDL_QuitSubSystem(SDL_INIT_JOYSTICK | SDL_INIT_GAMECONTROLLER);
    SDL_TLSCleanup();  // SDL did not create this thread
}

SdlPads::SdlPads(PadListener listener) : m_state(std::make_unique<State>()) {
    m_state->listener = std::move(listener);
    m_state->thread =
        std::jthread([state = m_state.get()](const std::stop_token& stop) { state->run(stop); });
}

SdlPads::~SdlPads() = default;

void SdlPads::rumble(int id, double strength, int milliseconds) {
    const std::lock_guard lock(m_state->mutex);
    if (m_state->rumbles.size() < 16) m_state->rumbles.push_back({id, strength, milliseconds});
}

}  // namespace leitstand
