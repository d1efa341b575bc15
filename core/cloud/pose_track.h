#pragma once

#include <chrono>
#include <map>
#include <optional>

#include "core/base/pose.h"
#include "core/base/time.h"

namespace leitstand {

/// Stamped poses of one object over time. They may be added in any order.
class PoseTrack {
public:
    /// Adds @p pose at @p stamp. Replaces an earlier pose with the same stamp. Ignores a pose that is not
    /// finite.
    void add(Time stamp, const Pose& pose);
    /// Returns the pose at @p stamp, interpolated between two stamps that are at most @p gap apart
    /// (translation linearly, rotation by slerp). Otherwise returns the nearest pose that is at most @p gap
    /// away; empty when there is none.
    [[nodiscard]] std::optional<Pose> at(Time stamp,
                                         std::chrono::nanoseconds gap = std::chrono::milliseconds(500)) const;
    void forgetBefore(Time stamp) { m_poses.erase(m_poses.begin(), m_poses.lower_bound(stamp)); }
    [[nodiscard]] bool empty() const { return m_poses.empty(); }

private:
    std::map<Time, Pose> m_poses;
};

}  // namespace leitstand
