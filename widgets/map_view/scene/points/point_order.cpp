#include "widgets/map_view/scene/points/point_order.h"

#include <algorithm>
#include <limits>

namespace leitstand {

PointOrder::PointOrder(const std::vector<std::uint32_t>& places) {
    constexpr std::uint32_t Most = std::numeric_limits<std::uint16_t>::max();
    if (std::any_of(places.begin(), places.end(), [](std::uint32_t place) { return place > Most; })) {
        m_wide.assign(places.begin(), places.end());
        return;
    }
    m_narrow.reserve(places.size());
    for (const std::uint32_t place : places) m_narrow.push_back(static_cast<std::uint16_t>(place));
}

std::size_t PointOrder::memory() const {
    return m_narrow.capacity() * sizeof(std::uint16_t) + m_wide.capacity() * sizeof(std::uint32_t);
}

}  // namespace leitstand
