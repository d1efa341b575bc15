#pragma once

#include <chrono>
#include <string>

#include "core/base/time.h"

namespace leitstand {

/// "2026-11-21" by the computer's time zone.
[[nodiscard]] std::string dateText(Time time);
/// "20:11:54", likewise.
[[nodiscard]] std::string clockText(Time time);
/// "12:05", minutes and seconds; hours before them where there are any.
[[nodiscard]] std::string spanText(std::chrono::nanoseconds span);

}  // namespace leitstand
