#pragma once

#include <chrono>
#include <string>

namespace leitstand {

struct ReviewIndex;

/// How long anything was recorded, without the gaps between.
[[nodiscard]] std::chrono::nanoseconds recordedTime(const ReviewIndex& index);
/// How often a sample of @p topic came of @p robot, over all that was recorded [Hz]; 0: none did.
[[nodiscard]] double usualRate(const ReviewIndex& index, const std::string& robot, const std::string& topic);
/// How often a key scan of @p robot did [Hz].
[[nodiscard]] double keyScanRate(const ReviewIndex& index, const std::string& robot);
/// Whether the mission has what the scanners of @p robot sent, more often than its key scans: not only what
/// was kept as evidence of finds.
[[nodiscard]] bool hasSlices(const ReviewIndex& index, const std::string& robot);

}  // namespace leitstand
