#pragma once

#include <QDateTime>
#include <QString>

#include "core/base/time.h"

namespace leitstand {

/// Returns the time of day of @p moment with seconds, in the format of the default QLocale: "20:11:54",
/// "8:11:54 PM". With @p tenths it is "20:11:54.3", with the locale's decimal point.
[[nodiscard]] QString timeOfDayText(const QTime& moment, bool tenths = false);
/// Returns the local time of @p at, in the format of timeOfDayText().
[[nodiscard]] QString wallText(Time at, bool tenths = false);

}  // namespace leitstand
