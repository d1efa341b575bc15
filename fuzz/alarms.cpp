#include <cmath>
#include <string>

#include "core/io/settings/alarm_file.h"
#include "fuzz/input_file.h"

/// Limits of alarms. What was read makes sense.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace leitstand;
    const std::string text(reinterpret_cast<const char*>(data), size);
    const auto limits = parseAlarmLimits(text, "alarms.yaml");
    if (!limits) return fuzz::requireNamed(limits.error(), "alarms.yaml");
    for (const double value : {limits->attitude, limits->batteryMinutes, limits->batteryShare, limits->gas,
                               limits->unanswered, limits->frozen, limits->clock})
        fuzz::require(std::isfinite(value) && value >= 0.0, "limits that are numbers");
    return 0;
}
