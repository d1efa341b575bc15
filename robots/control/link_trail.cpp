#include "robots/control/link_trail.h"

namespace leitstand {

void LinkTrail::moved(const Pose& baseInOdom, bool linkGood, bool returning) {
    const Eigen::Vector2d here = baseInOdom.translation().head<2>();
    if (!here.allFinite()) return;
    if (linkGood || m_places.empty()) {
        m_places = {here};
        m_atEnd = true;
        return;
    }
    if (!returning) {
        if ((m_places.back() - here).norm() >= m_spacing) m_places.push_back(here);
        m_atEnd = (m_places.front() - here).norm() < m_spacing;
        return;
    }
    while (m_places.size() > 1 && (m_places.back() - here).norm() < m_spacing) m_places.pop_back();
    m_atEnd = (m_places.front() - here).norm() < m_spacing;
}

Eigen::Vector2d LinkTrail::next() const {
    return m_places.empty() ? Eigen::Vector2d(Eigen::Vector2d::Zero()) : m_places.back();
}

}  // namespace leitstand
