#pragma once

#include <cstddef>
#include <vector>

#include "core/base/pose.h"

namespace leitstand {

/// The poses that an ICP went through. They show whether it only progresses slowly or runs in circles: with a
/// maximum pair distance, pairs can come and go for ever.
class PoseHistory {
public:
    /// Adds a pose and its cost per pair.
    void add(const Pose& pose, double cost);
    void clear() { m_entries.clear(); }

    /// Returns the number of last poses that form a cycle; 0: no cycle. The poses of a cycle repeat to within
    /// @p tolerance [m, rad], or stay within CycleDistance and CycleAngle without progress.
    [[nodiscard]] std::size_t cycle(double tolerance) const;
    /// The pose with the lowest cost among the last @p count ones; there must be that many.
    [[nodiscard]] const Pose& best(std::size_t count) const;
    /// Largest distance [m] and angle [rad] of the last @p count poses from best().
    struct Extent {
        double distance = 0.0, angle = 0.0;
    };
    [[nodiscard]] Extent extent(std::size_t count) const;

    static constexpr double CycleDistance = 1e-3;        ///< [m]
    static constexpr double CycleAngle = degrees(0.02);  ///< [rad]

private:
    struct Entry {
        Pose pose;
        double cost;
    };
    [[nodiscard]] bool wanders() const;
    [[nodiscard]] bool repeats(std::size_t period, double tolerance) const;

    std::vector<Entry> m_entries;
};

}  // namespace leitstand
