#pragma once

#include <vector>

#include "core/base/time.h"
#include "core/mission/timeline/timeline_marks.h"

namespace leitstand {

/// Converts moments of a mission to places on its timeline, from 0 (its start) to 1 (its end). Each gap in
/// the recording takes the same small share, whatever its length.
class TimelineAxis {
public:
    TimelineAxis() = default;
    /// @p stretches: periods in which something was recorded, in order and without overlaps.
    explicit TimelineAxis(std::vector<TimelineStretch> stretches);

    [[nodiscard]] bool empty() const { return m_parts.empty(); }
    [[nodiscard]] Time first() const;
    [[nodiscard]] Time last() const;
    [[nodiscard]] double placeOf(Time at) const;
    /// Returns the moment at @p place. Within a gap, returns the nearer end of the gap.
    [[nodiscard]] Time timeAt(double place) const;
    /// Returns the recorded time until @p at, without gaps.
    [[nodiscard]] std::chrono::nanoseconds recordedUntil(Time at) const;
    /// Returns the places where gaps begin and end.
    [[nodiscard]] std::vector<std::pair<double, double>> gaps() const;

    /// A tick of the axis.
    struct Tick {
        Time at{};
        double place = 0.0;
    };
    /// Returns ticks at round times of day in UTC, outside of gaps. @p apart: least distance between them, as
    /// a share of the axis; a tenth less is allowed.
    [[nodiscard]] std::vector<Tick> ticks(double apart) const;

private:
    struct Part {
        TimelineStretch stretch;
        double from = 0.0, to = 0.0;  ///< places on the timeline
    };
    std::vector<Part> m_parts;
};

}  // namespace leitstand
