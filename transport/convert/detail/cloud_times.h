#pragma once

#include <cstdint>
#include <vector>

#include "core/base/time.h"
#include "transport/convert/detail/checks.h"
#include "transport/convert/detail/cloud_column.h"

namespace leitstand::detail {

enum class TimeUnit : std::uint8_t { Nanoseconds, Seconds };

/// Returns the time of each point after @p stamp [ns]; 0 for points without a time. @p unit is the usual unit
/// of the values in @p column, but drivers disagree. If the largest value is above 1e14, values are
/// nanoseconds since 1970 or since the scanner's start. If @p unit is Seconds and the largest value is above
/// 1e8, they are seconds since then. All other values are relative to the stamp. Absolute times more than a
/// minute from the stamp come from the scanner's own clock: then the earliest point is placed at the stamp.
/// Error in @p checks: points more than a minute apart.
[[nodiscard]] std::vector<std::int64_t> relativeTimes(const CloudColumn& column, TimeUnit unit, Time stamp,
                                                      Checks& checks);

}  // namespace leitstand::detail
