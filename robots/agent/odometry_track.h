#pragma once

#include <deque>
#include <optional>
#include <utility>

#include "core/base/pose.h"
#include "core/base/time.h"

namespace leitstand {

/// Poses of a robot by its odometry in the last 6 s (longer than a sweep of any scanner), interpolated.
class OdometryTrack {
public:
    void add(Time at, const Pose& baseInOdom);
    /// Returns the pose at @p at; empty before the first and when nothing came for 0.3 s up to @p at.
    [[nodiscard]] std::optional<Pose> at(Time at) const;
    [[nodiscard]] std::optional<Pose> newest() const;

private:
    std::deque<std::pair<Time, Pose>> m_places;
};

}  // namespace leitstand
