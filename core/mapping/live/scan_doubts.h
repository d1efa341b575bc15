#pragma once

#include <cstdint>
#include <string>

namespace leitstand {

/// What @p doubts (bits of ScanDoubt) mean, for alarms and the log, in English; empty: none.
[[nodiscard]] std::string inWords(std::uint8_t doubts);

/// How certain a pose is, 0 to 1: from the share of the points that meet the map and the certainty of the
/// match (IcpResult::certainty).
[[nodiscard]] double certaintyOf(double overlap, double certainty);

}  // namespace leitstand
