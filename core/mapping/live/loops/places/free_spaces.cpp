#include "core/mapping/live/loops/places/free_spaces.h"

#include <algorithm>

namespace leitstand {

const FreeSpace& FreeSpaces::of(std::uint64_t id, const Scan& scan) {
    auto made = m_made.find(id);
    if (made == m_made.end()) {
        while (m_made.size() >= m_most) {
            m_made.erase(std::min_element(m_made.begin(), m_made.end(), [](const auto& a, const auto& b) {
                return a.second.used < b.second.used;
            }));
        }
        made = m_made.emplace(id, Made{FreeSpace(scan.points, m_settings)}).first;
    }
    made->second.used = ++m_calls;
    return made->second.free;
}

}  // namespace leitstand
