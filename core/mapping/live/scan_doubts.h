#pragma once

#include <cstdint>
#include <string>

namespace leitstand {

/// Returns the meaning of @p doubts (bits of ScanDoubt) as English text, for alarms and the log; empty: no
/// doubts.
[[nodiscard]] std::string inWords(std::uint8_t doubts);

/// Returns how certain a pose is, 0 to 1. @p overlap: share of the points that fit the map. @p certainty:
/// IcpResult::certainty.
[[nodiscard]] double certaintyOf(double overlap, double certainty);

}  // namespace leitstand
