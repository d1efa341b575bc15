#include "core/station/pad/pad_mapping.h"

#include <utility>

#include "core/robot/control/drive_keys.h"

namespace leitstand {
namespace {

constexpr double Hysteresis = 0.8;  ///< a pressed axis is released below this share of the press

}  // namespace

PadMapping::PadMapping(PadBindings bindings) : m_bindings(std::move(bindings)) {}

void PadMapping::setBindings(PadBindings bindings) {
    m_bindings = std::move(bindings);
    m_known = false;
    needNeutral();
}

void PadMapping::needNeutral() {
    m_triggerFree = m_sticksFree = m_camerasFree = m_jointsFree = false;
}

bool PadMapping::isHeld(const PadControl& control, const PadState& state, bool before) const {
    if (control.kind == PadControl::Kind::None) return false;
    return amountOf(control, state) >= m_bindings.press * (before ? Hysteresis : 1.0);
}

PadRequests PadMapping::update(const PadState& state, PadScope scope) {
    PadRequests requests;
    if (!state.connected) {
        m_held.fill(false);
        m_known = false;
        needNeutral();
        return requests;
    }
    const bool stopWasHeld = held(PadAction::Stop);
    for (const PadAction action : padActions()) {
        bool& held = m_held[static_cast<std::size_t>(action)];
        held = isHeld(m_bindings.at(action), state, held);
    }
    requests.stop = held(PadAction::Stop) && !stopWasHeld;
    const bool moves = scope == PadScope::All;
    if (!moves || requests.stop) needNeutral();
    readCommands(state, scope, requests);
    if (!moves) return requests;
    readDrive(state, requests);
    readCameras(state, requests);
    return requests;
}

void PadMapping::readCommands(const PadState& state, PadScope scope, PadRequests& requests) {
    m_commandHeld.resize(m_bindings.commands.size(), false);
    for (std::size_t i = 0; i < m_bindings.commands.size(); ++i) {
        const bool before = m_commandHeld[i], now = isHeld(m_bindings.commands[i].control, state, before);
        m_commandHeld[i] = now;
        // What is held when the pad is connected was not pressed for us.
        if (now && !before && m_known && scope != PadScope::Nothing)
            requests.commands.push_back(m_bindings.commands[i].id);
    }
    m_known = true;
}

void PadMapping::readDrive(const PadState& state, PadRequests& requests) {
    const bool trigger = held(PadAction::DeadMan);
    if (!trigger) {
        m_triggerFree = true;
        m_sticksFree = false;
        return;
    }
    const double forward = shapedOf(m_bindings, PadAction::Forward, state),
                 left = shapedOf(m_bindings, PadAction::SlideLeft, state),
                 turn = shapedOf(m_bindings, PadAction::TurnLeft, state);
    requests.driving = m_triggerFree;
    if (requests.driving && forward == 0.0 && turn == 0.0 && left == 0.0) m_sticksFree = true;
    requests.withoutEyes = requests.driving && held(PadAction::WithoutEyes);
    requests.needsNeutral = !m_triggerFree || !m_sticksFree;
    if (requests.needsNeutral) return;
    const double share = held(PadAction::Slow)    ? DriveKeys::Slowly
                         : held(PadAction::Turbo) ? 1.0
                                                  : DriveKeys::Usual;
    DriveVelocity requested;
    requested.forward = share * m_limits.speed * forward;
    requested.left = share * m_limits.speed * left;
    requested.turn = share * m_limits.turnRate * turn;
    requests.drive = limited(requested, m_limits);
}

void PadMapping::readCameras(const PadState& state, PadRequests& requests) {
    const double pan = shapedOf(m_bindings, PadAction::PanLeft, state),
                 tilt = shapedOf(m_bindings, PadAction::TiltUp, state);
    if (pan == 0.0 && tilt == 0.0) m_camerasFree = true;
    if (m_camerasFree) requests.cameras = {m_bindings.cameraRate * pan, m_bindings.cameraRate * tilt};
    if (!requests.driving) {
        m_jointsFree = false;
    } else if (tilt == 0.0) {
        m_jointsFree = true;
    }
    if (m_jointsFree) requests.joints = tilt;
}

}  // namespace leitstand
