#pragma once

#include <QDateTime>
#include <QString>

#include "core/base/time.h"

namespace leitstand {

/// The time of day of @p moment, with seconds, as the default QLocale writes it: "20:11:54", "8:11:54 PM";
/// with
/// @p tenths "20:11:54.3", its decimal point the locale's.
[[nodiscard]] QString timeOfDayText(const QTime& moment, bool tenths = false);
/// A moment as a wall clock shows it in local time, by timeOfDayText().
[[nodiscard]] QString wallText(Time at, bool tenths = false);

}  // namespace leitstand
