#include "app/services/finds/mode_book.h"

#include <iterator>

#include "core/event/event.h"
#include "core/event/status_samples.h"

namespace leitstand {

std::optional<bool> ModeBook::at(const Modes& modes, Time moment) {
    const auto after = modes.upper_bound(moment);
    return after == modes.begin() ? std::nullopt : std::optional(std::prev(after)->second);
}

void ModeBook::onEvent(const Event& event) {
    const auto* const mode = event.sample.as<ModeSample>();
    if (mode == nullptr) return;
    const std::scoped_lock lock(m_mutex);
    Modes& modes = m_modes[event.robot];
    if (at(modes, event.received) != mode->autonomous)
        modes.insert_or_assign(event.received, mode->autonomous);
}

std::optional<bool> ModeBook::autonomousAt(const std::string& robot, Time moment) const {
    const std::scoped_lock lock(m_mutex);
    const auto modes = m_modes.find(robot);
    return modes == m_modes.end() ? std::nullopt : at(modes->second, moment);
}

}  // namespace leitstand
