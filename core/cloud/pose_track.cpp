#include "core/cloud/pose_track.h"

#include <iterator>

namespace leitstand {
void PoseTrack::add(Time stamp, const Pose& pose) {
    if (pose.matrix().allFinite()) m_poses.insert_or_assign(stamp, pose);
}

std::optional<Pose> PoseTrack::at(Time stamp, std::chrono::nanoseconds gap) const {
    const auto after = m_poses.lower_bound(stamp);
    const auto before = after == m_poses.begin() ? m_poses.end() : std::prev(after);
    if (after != m_poses.end() && before != m_poses.end() && after->first - before->first <= gap) {
        const double share = std::chrono::duration<double>(stamp - before->first) /
                             std::chrono::duration<double>(after->first - before->first);
        return interpolated(before->second, after->second, share);
    }
    const bool afterFits = after != m_poses.end() && after->first - stamp <= gap;
    const bool beforeFits = before != m_poses.end() && stamp - before->first <= gap;
    if (afterFits && (!beforeFits || after->first - stamp < stamp - before->first)) return after->second;
    if (beforeFits) return before->second;
    return std::nullopt;
}

}  // namespace leitstand
