#pragma once

#include <chrono>
#include <string>

namespace leitstand {

struct ReviewIndex;

/// Returns the total recorded time, without the gaps.
[[nodiscard]] std::chrono::nanoseconds recordedTime(const ReviewIndex& index);
/// Returns the mean rate of samples of @p robot on @p topic over the recorded time [Hz]; 0: there are none.
[[nodiscard]] double usualRate(const ReviewIndex& index, const std::string& robot, const std::string& topic);
/// Returns the mean rate of key scans of @p robot [Hz].
[[nodiscard]] double keyScanRate(const ReviewIndex& index, const std::string& robot);
/// Whether the log has the slices of the scanners of @p robot: one scanner has more samples than the robot
/// has key scans. If there are fewer, they were kept only as evidence of finds.
[[nodiscard]] bool hasSlices(const ReviewIndex& index, const std::string& robot);

}  // namespace leitstand
