#include "robots/control/link_trail.h"

namespace leitstand {

void LinkTrail::moved(const Pose& baseInOdom, bool linkGood, bool returning) {
    const Eigen::Vector3d here = baseInOdom.translation();
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

Eigen::Vector3d LinkTrail::next() const {
    return m_places.empty() ? Eigen::Vector3d(Eigen::Vector3d::Zero()) : m_places.back();
}

}  // namespace leitstand
