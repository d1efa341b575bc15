#include "core/mapping/live/map/moved_places.h"

#include <algorithm>
#include <cstddef>

namespace leitstand {

MovedPlaces::MovedPlaces(const LiveMap& before, const LiveMap& after) {
    std::size_t now = 0;  // both are by rising id
    for (const LiveKeyScan& scan : before.scans) {
        while (now < after.scans.size() && after.scans[now].id < scan.id) ++now;
        if (now == after.scans.size()) break;
        const LiveKeyScan& same = after.scans[now];
        if (same.id != scan.id || !scan.counts() || !same.counts()) continue;
        const Pose &was = scan.pose.scanInMap, &is = same.pose.scanInMap;
        m_scans.push_back({was.translation(), is * was.inverse()});
        m_any = m_any || was.matrix() != is.matrix();
    }
}

Pose MovedPlaces::at(const Eigen::Vector3d& place) const {
    const auto nearest =
        std::min_element(m_scans.begin(), m_scans.end(), [&](const Moved& a, const Moved& b) {
            return (a.was - place).squaredNorm() < (b.was - place).squaredNorm();
        });
    return nearest == m_scans.end() ? Pose::Identity() : nearest->correction;
}

}  // namespace leitstand
