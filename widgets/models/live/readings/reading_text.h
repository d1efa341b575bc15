#pragma once

#include <optional>
#include <string>

#include <QString>

#include "core/robot/readings/reading_description.h"

namespace leitstand {

/// Returns the title of a reading (ReadingDescription::title): usual ones in the window's language.
[[nodiscard]] QString readingTitle(const std::string& title);

/// Returns @p value with @p unit: "23.5 °C", "–" if it is unknown. Without @p decimals, it has as many digits
/// after the point as people read at a glance.
[[nodiscard]] QString readingText(double value, const std::string& unit,
                                  std::optional<int> decimals = std::nullopt);

/// Returns where a number should stay: "10 to 40", "≥ 10", "≤ 40"; empty: anywhere.
[[nodiscard]] QString rangeText(const std::optional<double>& low, const std::optional<double>& high);
/// Returns the range in which nobody need look, then the one in which nobody need act: "≤ 40 / ≤ 60"; empty:
/// there are no limits.
[[nodiscard]] QString limitsText(const ReadingLimits& limits);

}  // namespace leitstand
