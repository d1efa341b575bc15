#include "robots/simulation/world/pose_history.h"

#include <algorithm>

namespace leitstand::simulation {

void PoseHistory::add(Time at, const Pose& pose) {
    if (!m_entries.empty() && m_entries.back().at == at) {
        m_entries.back().pose = pose;
        return;
    }
    m_entries.push_back({at, pose});
    // The last pose before the time that is kept stays, to interpolate from.
    while (m_entries.size() > 2 && m_entries[1].at < at - Kept) m_entries.pop_front();
}

Pose PoseHistory::at(Time at) const {
    if (m_entries.empty()) return Pose::Identity();
    const auto later = std::lower_bound(m_entries.begin(), m_entries.end(), at,
                                        [](const Entry& entry, Time time) { return entry.at < time; });
    if (later == m_entries.begin()) return m_entries.front().pose;
    if (later == m_entries.end()) return m_entries.back().pose;
    const Entry& before = *std::prev(later);
    const double share =
        static_cast<double>((at - before.at).count()) / static_cast<double>((later->at - before.at).count());
    return interpolated(before.pose, later->pose, share);
}

}  // namespace leitstand::simulation
