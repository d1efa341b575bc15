#pragma once

#include <cstdint>
#include <vector>

#include "core/base/time.h"
#include "transport/convert/detail/checks.h"
#include "transport/convert/detail/cloud_column.h"

namespace leitstand::detail {

enum class TimeUnit : std::uint8_t { Nanoseconds, Seconds };

/// Returns times of points after @p stamp [ns]. Drivers disagree: values beyond 1e14 are nanoseconds since
/// 1970 or the scanner's start. Values beyond 1e8 are seconds since then; all others already count from the
/// stamp. Times farther than a minute from the stamp come from the scanner's own clock. They count from the
/// earliest point, which is placed at the stamp. Points without a time get 0.
[[nodiscard]] std::vector<std::int64_t> relativeTimes(const CloudColumn& column, TimeUnit unit, Time stamp,
                                                      Checks& checks);

}  // namespace leitstand::detail
