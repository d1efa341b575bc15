#include "robots/control/link_trail.h"

#include "robots/control/driving/floor_memory.h"

namespace leitstand {

bool LinkTrail::isAt(const Eigen::Vector3d& place, const Eigen::Vector3d& here) const {
    return (place - here).head<2>().norm() < m_spacing && FloorMemory::isSameFloor(place.z(), here.z());
}

void LinkTrail::moved(const Pose& baseInOdom, bool linkGood, bool returning) {
    const Eigen::Vector3d here = baseInOdom.translation();
    if (!here.allFinite()) return;
    if (linkGood || m_places.empty()) {
        m_places = {here};
        m_atEnd = true;
        return;
    }
    if (!returning) {
        if (!isAt(m_places.back(), here)) m_places.push_back(here);
        m_atEnd = isAt(m_places.front(), here);
        return;
    }
    while (m_places.size() > 1 && isAt(m_places.back(), here)) m_places.pop_back();
    m_atEnd = isAt(m_places.front(), here);
}

Eigen::Vector3d LinkTrail::next() const {
    return m_places.empty() ? Eigen::Vector3d(Eigen::Vector3d::Zero()) : m_places.back();
}

}  // namespace leitstand
