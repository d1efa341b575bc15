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

    /// Adds a pose at @p at, which must not be before the last pose. A second pose for the same time replaces
    /// the first.
    void add(Time at, const Pose& pose);
    /// Returns the interpolated pose at @p at. Before the first pose, returns the first; after the last, the
    /// last.
    [[nodiscard]] Pose at(Time at) const;

private:
    struct Entry {
        Time at;
        Pose pose;
    };
    std::deque<Entry> m_entries;
};

}  // namespace leitstand::simulation
