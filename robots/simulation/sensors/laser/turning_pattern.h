#pragma once

#include <chrono>
#include <cstdint>

#include <Eigen/Core>

#include "core/base/pose.h"

namespace leitstand::simulation {

/// Times and directions of the shots of an upright plane scanner that turns continuously to the left about
/// the vertical axis. Raw scans are numbered from 0 at the start. The raw scan that completes a turn is also
/// the first one of the next turn (paper, section 2: 181 x 161 points).
struct TurningPattern {
    int rawScans = 180;  ///< number of headings per turn; one more raw scan repeats the first heading
    int points = 161;    ///< number of points per raw scan
    double lowest = degrees(-70);  ///< elevation of a raw scan's first point [rad]
    double step = degrees(1);      ///< angle between points, upwards [rad]
    /// Number of shots in a whole turn of the mirror; there is one turn per raw scan.
    double shotsOfCircle = 360.0;
    std::chrono::nanoseconds turn = std::chrono::milliseconds(2300);  ///< time of a turn
    std::chrono::nanoseconds slice = std::chrono::milliseconds(100);  ///< time of one slice that is sent

    /// Returns the time from the start to the first shot of @p rawScan.
    [[nodiscard]] std::chrono::nanoseconds startOf(std::int64_t rawScan) const;
    /// Returns the time from the first shot of a raw scan to its point @p point.
    [[nodiscard]] std::chrono::nanoseconds shotAfter(int point) const;
    /// Returns the direction of a shot (unit length) in the frame of the mount, which does not turn. All
    /// shots of a raw scan have the same heading.
    [[nodiscard]] Eigen::Vector3d direction(std::int64_t rawScan, int point) const;
    [[nodiscard]] double heading(std::int64_t rawScan) const;  ///< at least 0 and below 2 pi [rad]
    [[nodiscard]] int row(std::int64_t rawScan) const;         ///< number of the raw scan within its turn
    /// Returns the number (from 0) of the slice in which @p rawScan is sent: the one in which it starts.
    [[nodiscard]] std::int64_t sliceOf(std::int64_t rawScan) const;
    /// Returns the first raw scan that starts at or after @p since.
    [[nodiscard]] std::int64_t firstFrom(std::chrono::nanoseconds since) const;
};

}  // namespace leitstand::simulation
