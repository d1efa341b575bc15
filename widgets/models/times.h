#pragma once

#include <QDateTime>
#include <QString>

namespace leitstand {

/// The time of day of @p moment, with seconds, as the default QLocale writes it: "20:11:54", "8:11:54 PM";
/// with
/// @p tenths "20:11:54.3", its decimal point the locale's.
[[nodiscard]] QString timeOfDayText(const QTime& moment, bool tenths = false);

}  // namespace leitstand
