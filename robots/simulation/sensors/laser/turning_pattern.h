#pragma once

#include <chrono>
#include <cstdint>

#include <Eigen/Core>

#include "core/base/pose.h"

namespace leitstand::simulation {

/// Times and directions of the shots of an upright plane scanner that turns about the vertical axis without
/// end, always to the left. Raw scans are numbered from 0 at the start. The raw scan that closes a turn is
/// also the first one of the next turn (paper, section 2: 181 x 161 points).
struct TurningPattern {
    int rawScans = 180;            ///< different headings per turn; one more raw scan repeats the first
    int points = 161;              ///< per raw scan
    double lowest = degrees(-70);  ///< elevation of a raw scan's first point [rad]
    double step = degrees(1);      ///< from point to point, upwards [rad]
    double shotsOfCircle = 360.0;  ///< points in a whole turn of the mirror, one turn per raw scan
    std::chrono::nanoseconds turn = std::chrono::milliseconds(2300);  ///< time of a turn
    std::chrono::nanoseconds slice = std::chrono::milliseconds(100);  ///< time of one slice that is sent

    /// Returns the time from the start to the first shot of @p rawScan.
    [[nodiscard]] std::chrono::nanoseconds startOf(std::int64_t rawScan) const;
    /// Returns the time from the raw scan's first shot to that of @p point.
    [[nodiscard]] std::chrono::nanoseconds shotAfter(int point) const;
    /// Returns the direction of a shot, unit length, in the frame of the mount, which does not turn. All
    /// shots of a raw scan have the same heading.
    [[nodiscard]] Eigen::Vector3d direction(std::int64_t rawScan, int point) const;
    [[nodiscard]] double heading(std::int64_t rawScan) const;  ///< from 0 up to below 2 pi [rad]
    [[nodiscard]] int row(std::int64_t rawScan) const;         ///< within its turn
    /// Returns the slice, from 0, with which @p rawScan is sent: the one in which it starts.
    [[nodiscard]] std::int64_t sliceOf(std::int64_t rawScan) const;
    /// Returns the first raw scan that starts at or after @p since.
    [[nodiscard]] std::int64_t firstFrom(std::chrono::nanoseconds since) const;
};

}  // namespace leitstand::simulation
