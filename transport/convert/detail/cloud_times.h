#pragma once

#include <cstdint>
#include <vector>

#include "core/base/time.h"
#include "transport/convert/detail/checks.h"
#include "transport/convert/detail/cloud_column.h"

namespace leitstand::detail {

enum class TimeUnit : std::uint8_t { Nanoseconds, Seconds };

/// Returns the time of each point after @p stamp [ns]; 0 for points without a time. @p unit is that of the
/// values in @p column, but drivers disagree. Values are nanoseconds since 1970 or since the scanner's start
/// when the largest is above 1e14. They are seconds since then when @p unit is Seconds and the largest is
/// above 1e8. All other values count from the stamp. Absolute times more than a minute from the stamp come
/// from the scanner's own clock: the earliest point is placed at the stamp. Error in @p checks: points
/// farther than a minute apart.
[[nodiscard]] std::vector<std::int64_t> relativeTimes(const CloudColumn& column, TimeUnit unit, Time stamp,
                                                      Checks& checks);

}  // namespace leitstand::detail
