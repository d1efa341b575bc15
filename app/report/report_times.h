#pragma once

#include <QString>

#include "core/base/time.h"

namespace leitstand {

// Dates and times of the computer's time zone, as the default QLocale writes them.

/// "21.11.2026", "2026/11/21", "11/21/2026": always with the whole year.
[[nodiscard]] QString reportDate(Time time);
/// "20:11:54", "8:11:54 PM".
[[nodiscard]] QString reportClock(Time time);

}  // namespace leitstand
