#pragma once

#include <deque>
#include <optional>
#include <utility>

#include "core/base/pose.h"
#include "core/base/time.h"

namespace leitstand {

/// Poses of a robot from its odometry in the last 6 s (longer than a sweep of any scanner).
class OdometryTrack {
public:
    void add(Time at, const Pose& baseInOdom);
    /// Returns the interpolated pose at @p at. Up to 0.3 s outside the known poses, returns the first or the
    /// last one. Empty: farther outside.
    [[nodiscard]] std::optional<Pose> at(Time at) const;
    [[nodiscard]] std::optional<Pose> newest() const;

private:
    std::deque<std::pair<Time, Pose>> m_places;
};

}  // namespace leitstand
