#pragma once

#include <cstdint>
#include <vector>

#include "core/base/time.h"
#include "transport/convert/detail/checks.h"
#include "transport/convert/detail/cloud_column.h"

namespace leitstand::detail {

enum class TimeUnit : std::uint8_t { Nanoseconds, Seconds };

/// Times of points after @p stamp [ns]. Drivers disagree: values beyond 1e14 are nanoseconds since 1970 or
/// the scanner's start, beyond 1e8 seconds since then, others are after the stamp already. Times of a clock
/// of the scanner's own, farther than a minute from the stamp, count from the earliest point, which is then
/// taken at the stamp. Points without a time have 0.
[[nodiscard]] std::vector<std::int64_t> relativeTimes(const CloudColumn& column, TimeUnit unit, Time stamp,
                                                      Checks& checks);

}  // namespace leitstand::detail
