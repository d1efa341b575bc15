#pragma once

#include <cstdint>
#include <string>

namespace leitstand {

/// Returns the meaning of @p doubts (bits of ScanDoubt), for alarms and the log, in English; empty: none.
[[nodiscard]] std::string inWords(std::uint8_t doubts);

/// Returns how certain a pose is, 0 to 1: from the share of the points that meet the map and the certainty of
/// the match (IcpResult::certainty).
[[nodiscard]] double certaintyOf(double overlap, double certainty);

}  // namespace leitstand
