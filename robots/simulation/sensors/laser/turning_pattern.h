#pragma once

#include <chrono>
#include <cstdint>

#include <Eigen/Core>

#include "core/base/pose.h"

namespace leitstand::simulation {

/// When and where to a plane scanner shoots that stands upright and is turned about the vertical axis without
/// end, always to the left. Raw scans are numbered from 0 at the start; the one that closes a turn (paper,
/// section 2: 181 x 161 points) is the first of the next and belongs to both.
struct TurningPattern {
    int rawScans = 180;            ///< of different headings a turn; one more repeats the first
    int points = 161;              ///< a raw scan
    double lowest = degrees(-70);  ///< elevation of a raw scan's first point [rad]
    double step = degrees(1);      ///< from point to point, upwards [rad]
    double shotsOfCircle = 360.0;  ///< points in a whole turn of the mirror, one a raw scan
    std::chrono::nanoseconds turn = std::chrono::milliseconds(2300);  ///< time of a turn
    std::chrono::nanoseconds slice = std::chrono::milliseconds(100);  ///< time of what is sent at once

    /// Since the start, of the first shot of @p rawScan.
    [[nodiscard]] std::chrono::nanoseconds startOf(std::int64_t rawScan) const;
    /// After the raw scan's first shot.
    [[nodiscard]] std::chrono::nanoseconds shotAfter(int point) const;
    /// In the frame of the mount, which does not turn; unit length. One heading a raw scan.
    [[nodiscard]] Eigen::Vector3d direction(std::int64_t rawScan, int point) const;
    [[nodiscard]] double heading(std::int64_t rawScan) const;  ///< from 0 up to below 2 pi [rad]
    [[nodiscard]] int row(std::int64_t rawScan) const;         ///< within its turn
    /// Slice, from 0, in which @p rawScan is sent: the one in which it starts.
    [[nodiscard]] std::int64_t sliceOf(std::int64_t rawScan) const;
    /// First raw scan that starts at or after @p since.
    [[nodiscard]] std::int64_t firstFrom(std::chrono::nanoseconds since) const;
};

}  // namespace leitstand::simulation
