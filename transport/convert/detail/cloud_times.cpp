#include "transport/convert/detail/cloud_times.h"

#include <cmath>
#include <limits>

namespace leitstand::detail {
namespace {

constexpr double SureNanoseconds = 1e14;  // three million years if it were seconds
constexpr double SureAbsolute = 1e8;      // seconds: three years
constexpr std::int64_t Minute = 60'000'000'000;
constexpr double NanosecondsOfSecond = 1e9;

/// Returns @p value in nanoseconds. Converts whole seconds separately: one double for both loses 200 ns.
std::int64_t nanoseconds(double value, TimeUnit unit) {
    if (unit == TimeUnit::Nanoseconds) return static_cast<std::int64_t>(value);
    const double whole = std::floor(value);
    return static_cast<std::int64_t>(whole) * 1'000'000'000 +
           std::llround((value - whole) * NanosecondsOfSecond);
}

}  // namespace

std::vector<std::int64_t> relativeTimes(const CloudColumn& column, TimeUnit unit, Time stamp,
                                        Checks& checks) {
    double first = std::numeric_limits<double>::quiet_NaN(), most = 0.0;
    forEachValue(column, [&](std::size_t, auto raw) {
        const auto value = static_cast<double>(raw);
        if (!std::isfinite(value)) return;
        if (std::isnan(first) && value != 0.0) first = value;
        most = std::max(most, std::abs(value));
    });
    if (most > SureNanoseconds) unit = TimeUnit::Nanoseconds;
    const bool absolute = most > (unit == TimeUnit::Seconds ? SureAbsolute : SureNanoseconds);
    const double limit = unit == TimeUnit::Seconds ? 4e9 : 4e18;  // differences stay within an int64
    checks.require(most < limit, "fields", "times: expected less than {}, found {}", limit, most);
    if (!checks.ok()) return {};

    std::int64_t origin = absolute ? stamp.time_since_epoch().count() : 0;
    if (absolute && std::abs(nanoseconds(first, unit) - origin) > Minute) {
        origin = nanoseconds(first, unit);
        forEachValue(column, [&](std::size_t, auto raw) {
            const auto value = static_cast<double>(raw);
            if (std::isfinite(value) && value != 0.0) origin = std::min(origin, nanoseconds(value, unit));
        });
    }
    std::vector<std::int64_t> times(column.rows * column.columns);
    std::int64_t farthest = 0;
    forEachValue(column, [&](std::size_t i, auto raw) {
        const auto value = static_cast<double>(raw);
        if (!std::isfinite(value) || (absolute && value == 0.0)) return;
        times[i] = nanoseconds(value, unit) - origin;
        farthest = std::max(farthest, std::abs(times[i]));
    });
    checks.require(farthest <= Minute, "fields", "times: expected a sweep of less than a minute, found {} s",
                   static_cast<double>(farthest) / NanosecondsOfSecond);
    return times;
}

}  // namespace leitstand::detail
