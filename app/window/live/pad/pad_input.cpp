#include "app/window/live/pad/pad_input.h"

#include <algorithm>
#include <utility>

#include "core/station/pad/pad_overlay.h"

namespace leitstand {

PadInput::PadInput(PadInputSettings settings, QObject* parent)
    : QObject(parent),
      m_settings(std::move(settings)),
      m_sdl(std::make_unique<SdlPads>(
          PadListener{.onCame = [this](const PadInfo& info) { came(info); },
                      .onState = [this](int id, const PadState& state) { receive(id, state); },
                      .onGone = [this](int id) { went(id); },
                      .onTrouble =
                          [this](const std::string& text) {
                              hop([this, words = QString::fromStdString(text)] { emit notified(words); });
                          }})) {}

PadInput::~PadInput() = default;

void PadInput::came(const PadInfo& info) {
    std::string warning;
    const PadBindings bindings = m_settings.memory.bindings(info.guid, info.layout, warning);
    watchStop(info.id, bindings);
    hop([this, info, bindings, words = QString::fromStdString(warning)] {
        if (!words.isEmpty()) emit notified(words);
        add(info, bindings);
    });
}

void PadInput::receive(int id, const PadState& state) {
    bool stop = false;
    {
        const std::lock_guard lock(m_mutex);
        stop = m_stops[id].update(state, PadScope::Nothing).stop;
    }
    if (stop && m_settings.onStop) m_settings.onStop();
    hop([this, id, state, stop] {
        if (stop) {
            needNeutral();
            emit stopPressed();
        }
        take(id, state);
    });
}

void PadInput::went(int id) {
    {
        const std::lock_guard lock(m_mutex);
        m_stops.erase(id);
    }
    hop([this, id] { remove(id); });
}

void PadInput::watchStop(int id, const PadBindings& bindings) {
    const std::lock_guard lock(m_mutex);
    m_stops[id].setBindings(bindings);
}

void PadInput::add(const PadInfo& info, const PadBindings& bindings) {
    m_pads.push_back({info, {}});
    if (m_chosen < 0) {
        m_chosen = info.id;
        useOwn(bindings);
    }
    const QString name = QString::fromStdString(info.name);
    emit connected(name);
    const bool stops = bindings.at(PadAction::Stop).kind != PadControl::Kind::None;
    if (!stops)
        emit notified(tr("%1 has no known controls: give it some in the gamepad's dialog.").arg(name));
    emit padsChanged();
}

void PadInput::take(int id, const PadState& state) {
    const auto pad =
        std::find_if(m_pads.begin(), m_pads.end(), [id](const Pad& one) { return one.info.id == id; });
    if (pad == m_pads.end()) return;
    const bool changed = pad->state != state;
    pad->state = state;
    if (id != m_chosen) return;
    update();
    if (changed) emit moved();
}

void PadInput::remove(int id) {
    const auto pad =
        std::find_if(m_pads.begin(), m_pads.end(), [id](const Pad& one) { return one.info.id == id; });
    if (pad == m_pads.end()) return;
    const QString name = QString::fromStdString(pad->info.name);
    m_pads.erase(pad);
    if (id == m_chosen) choose(m_pads.empty() ? -1 : m_pads.front().info.id);
    emit gone(name);
    emit padsChanged();
}

void PadInput::choose(int id) {
    if (id == m_chosen) return;
    m_chosen = id;
    PadBindings bindings;
    {
        const std::lock_guard lock(m_mutex);
        const auto found = m_stops.find(id);
        if (found != m_stops.end()) bindings = found->second.bindings();
    }
    useOwn(bindings);
    update();
    emit padsChanged();
    emit moved();
}

const PadInput::Pad* PadInput::chosenPad() const {
    const auto pad = std::find_if(m_pads.begin(), m_pads.end(),
                                  [this](const Pad& one) { return one.info.id == m_chosen; });
    return pad == m_pads.end() ? nullptr : &*pad;
}

void PadInput::update() {
    const Pad* const pad = chosenPad();
    publish(m_mapping.update(pad == nullptr ? PadState{} : pad->state, m_scope));
}

void PadInput::publish(const PadRequests& requests) {
    const PadRequests before = std::exchange(m_last, requests);
    if (requests.driving || before.driving)
        emit sticks(requests.drive, requests.driving, requests.withoutEyes);
    if (requests.needsNeutral != before.needsNeutral) emit needsNeutral(requests.needsNeutral);
    if (requests.joints != 0.0 || before.joints != 0.0) emit joints(requests.joints);
    if (requests.cameras != PanTiltRate{} || before.cameras != PanTiltRate{}) emit panTilt(requests.cameras);
    for (const std::string& command : requests.commands) emit commandWanted(QString::fromStdString(command));
}

std::vector<PadInfo> PadInput::pads() const {
    std::vector<PadInfo> infos;
    for (const Pad& pad : m_pads) infos.push_back(pad.info);
    return infos;
}

PadInfo PadInput::chosen() const {
    const Pad* const pad = chosenPad();
    return pad == nullptr ? PadInfo{} : pad->info;
}

PadBindings PadInput::bindings() const {
    return m_mapping.bindings();
}

PadState PadInput::state() const {
    const Pad* const pad = chosenPad();
    return pad == nullptr ? PadState{} : pad->state;
}

void PadInput::setBindings(const PadBindings& bindings) {
    const PadInfo pad = chosen();
    if (pad.id < 0) return;
    useOwn(bindings);
    watchStop(pad.id, bindings);
    if (const auto kept = m_settings.memory.keep(pad.guid, pad.name, bindings); !kept)
        emit notified(QString::fromStdString(kept.error().text));
    update();
    emit padsChanged();
}

void PadInput::useOwn(const PadBindings& bindings) {
    m_own = bindings;
    PadOverlay overlay = withCommands(bindings, m_layout);
    m_mapping.setBindings(std::move(overlay.bindings));
}

void PadInput::setLayoutCommands(std::map<std::string, std::string> byButton) {
    if (byButton == m_layout) return;
    m_layout = std::move(byButton);
    useOwn(PadBindings(m_own));
    update();
    emit padsChanged();
}

void PadInput::setLimits(const DriveLimits& limits) {
    m_mapping.setLimits(limits);
}

void PadInput::setScope(PadScope scope) {
    if (scope == m_scope) return;
    m_scope = scope;
    update();
}

void PadInput::needNeutral() {
    m_mapping.needNeutral();
    update();
}

void PadInput::rumble(double strength, int milliseconds) {
    if (m_chosen >= 0) m_sdl->rumble(m_chosen, strength, milliseconds);
}

}  // namespace leitstand
