#include "robots/agent/odometry_track.h"

#include <algorithm>
#include <chrono>
#include <iterator>

namespace leitstand {
namespace {

constexpr auto Kept = std::chrono::seconds(6);
constexpr auto Bridged = std::chrono::milliseconds(300);

}  // namespace

void OdometryTrack::add(Time at, const Pose& baseInOdom) {
    if (!m_places.empty() && at <= m_places.back().first) return;
    m_places.emplace_back(at, baseInOdom);
    while (m_places.front().first < at - Kept) m_places.pop_front();
}

std::optional<Pose> OdometryTrack::at(Time at) const {
    const auto after =
        std::find_if(m_places.begin(), m_places.end(), [at](const auto& place) { return place.first >= at; });
    if (after == m_places.end()) {
        if (m_places.empty() || at > m_places.back().first + Bridged) return std::nullopt;
        return m_places.back().second;
    }
    if (after == m_places.begin()) {
        if (after->first > at + Bridged) return std::nullopt;
        return after->second;
    }
    const auto before = std::prev(after);
    const double share = std::chrono::duration<double>(at - before->first) / (after->first - before->first);
    return interpolated(before->second, after->second, share);
}

std::optional<Pose> OdometryTrack::newest() const {
    if (m_places.empty()) return std::nullopt;
    return m_places.back().second;
}

}  // namespace leitstand
