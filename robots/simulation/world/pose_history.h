#pragma once

#include <chrono>
#include <deque>

#include "core/base/pose.h"
#include "core/base/time.h"

namespace leitstand::simulation {

/// Where something was during the last seconds.
class PoseHistory {
public:
    static constexpr std::chrono::seconds Kept{5};

    /// @p at: not before the last one; a second pose of a moment replaces the first.
    void add(Time at, const Pose& pose);
    /// Interpolated; before the first and after the last pose: that one.
    [[nodiscard]] Pose at(Time at) const;

private:
    struct Entry {
        Time at;
        Pose pose;
    };
    std::deque<Entry> m_entries;
};

}  // namespace leitstand::simulation
