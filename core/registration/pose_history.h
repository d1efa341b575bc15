#pragma once

#include <cstddef>
#include <vector>

#include "core/base/pose.h"

namespace leitstand {

/// The poses during an ICP. They show whether it only progresses slowly or repeats itself: with a maximum
/// pair distance, the same pairs can appear and disappear for ever.
class PoseHistory {
public:
    /// Adds a pose and its cost per pair.
    void add(const Pose& pose, double cost);
    void clear() { m_entries.clear(); }

    /// Returns how many of the last poses form a cycle; 0: no cycle. Poses form a cycle if they repeat within
    /// @p tolerance [m, rad], or stay within CycleDistance and CycleAngle without progress.
    [[nodiscard]] std::size_t cycle(double tolerance) const;
    /// The pose with the lowest cost among the last @p count poses; there must be that many.
    [[nodiscard]] const Pose& best(std::size_t count) const;
    /// Largest distance [m] and angle [rad] of the last @p count poses from best().
    struct Extent {
        double distance = 0.0, angle = 0.0;
    };
    [[nodiscard]] Extent extent(std::size_t count) const;

    static constexpr double CycleDistance = 1e-3;        ///< largest distance between poses of a cycle [m]
    static constexpr double CycleAngle = degrees(0.02);  ///< largest angle between poses of a cycle [rad]

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
