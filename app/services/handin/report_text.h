#pragma once

#include <chrono>
#include <string>

#include "core/base/time.h"

namespace leitstand {

/// "2026-11-21" in the computer's time zone.
[[nodiscard]] std::string dateText(Time time);
/// "20:11:54" in the computer's time zone.
[[nodiscard]] std::string clockText(Time time);
/// "12:05", minutes and seconds; if there are hours, they come first.
[[nodiscard]] std::string spanText(std::chrono::nanoseconds span);

}  // namespace leitstand
