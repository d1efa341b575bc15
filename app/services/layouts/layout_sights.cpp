#include "app/services/layouts/layout_sights.h"

namespace leitstand {

MapSight LayoutSights::enter(const WindowLayout& layout, const MapSight& now) {
    if (!layout.map.isMeaningful()) return now;
    m_own = own(now);
    if (m_holder) m_kept[m_holder->name] = now;
    m_holder = Holder{layout.name, layout.map};
    if (const auto kept = m_kept.find(layout.name); kept != m_kept.end()) return kept->second;
    return {layout.map.look.value_or(m_own.look), layout.map.follow.value_or(m_own.follow)};
}

void LayoutSights::forget(const std::string& name) {
    m_kept.erase(name);
    if (m_holder && m_holder->name == name) m_holder.reset();
}

MapSight LayoutSights::own(const MapSight& now) const {
    if (!m_holder) return m_own;
    return {m_holder->ofLayout.look ? m_own.look : now.look,
            m_holder->ofLayout.follow ? m_own.follow : now.follow};
}

}  // namespace leitstand
