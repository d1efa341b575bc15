#pragma once

#include <QString>

#include "core/base/time.h"

namespace leitstand {

// Dates and times are in the computer's time zone and in the format of the default QLocale.

/// Returns the date, always with four digits for the year: "21.11.2026", "2026/11/21", "11/21/2026".
[[nodiscard]] QString reportDate(Time time);
/// Returns the time of day: "20:11:54", "8:11:54 PM".
[[nodiscard]] QString reportClock(Time time);

}  // namespace leitstand
