#include "app/session/finds/first_told.h"

#include <iterator>
#include <variant>

namespace leitstand {

std::optional<bool> FirstToldBook::at(const Modes& modes, Time moment) {
    const auto after = modes.upper_bound(moment);
    return after == modes.begin() ? std::nullopt : std::optional(std::prev(after)->second);
}

void FirstToldBook::take(const Event& event) {
    if (const auto* const mode = std::get_if<ModeSample>(&event.sample)) {
        const std::scoped_lock lock(m_mutex);
        Modes& modes = m_modes[event.robot];
        if (at(modes, event.received) != mode->autonomous)
            modes.insert_or_assign(event.received, mode->autonomous);
    } else if (const auto* const candidate = std::get_if<CandidateSample>(&event.sample)) {
        const std::scoped_lock lock(m_mutex);
        if (m_first.contains(candidate->id)) return;
        FirstTold first;
        first.stamp = candidate->stamp;
        if (!candidate->cues.empty()) first.robot = candidate->cues.front().robot;
        const auto modes = m_modes.find(first.robot);
        if (modes != m_modes.end()) first.autonomous = at(modes->second, event.received);
        m_first.emplace(candidate->id, std::move(first));
    }
}

void FirstToldBook::toldBefore(std::uint32_t candidate) {
    const std::scoped_lock lock(m_mutex);
    m_first.emplace(candidate, std::nullopt);
}

std::optional<FirstTold> FirstToldBook::of(std::uint32_t candidate) const {
    const std::scoped_lock lock(m_mutex);
    const auto found = m_first.find(candidate);
    return found == m_first.end() ? std::nullopt : found->second;
}

std::optional<bool> FirstToldBook::autonomousAt(const std::string& robot, Time moment) const {
    const std::scoped_lock lock(m_mutex);
    const auto modes = m_modes.find(robot);
    return modes == m_modes.end() ? std::nullopt : at(modes->second, moment);
}

}  // namespace leitstand
