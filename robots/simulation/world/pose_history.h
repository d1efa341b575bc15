#pragma once

#include <chrono>
#include <deque>

#include "core/base/pose.h"
#include "core/base/time.h"

namespace leitstand::simulation {

/// Poses of something during the last seconds.
class PoseHistory {
public:
    static constexpr std::chrono::seconds Kept{5};

    /// Adds a pose at @p at, which must not be before the last one. A second pose of the same time replaces
    /// the first.
    void add(Time at, const Pose& pose);
    /// Returns the pose at @p at, interpolated; before the first pose and after the last one, that pose.
    [[nodiscard]] Pose at(Time at) const;

private:
    struct Entry {
        Time at;
        Pose pose;
    };
    std::deque<Entry> m_entries;
};

}  // namespace leitstand::simulation
