#pragma once

#include <chrono>
#include <functional>
#include <string>

#include "core/base/result.h"

namespace leitstand {

/// Waits until the function @p has returns true: until the mission holds what was published last. Errors, in
/// words: the log's fault, as @p problem returns it, or that @p patience is over. In that case nobody knows
/// whether it was written.
[[nodiscard]] Result<void> untilWritten(const std::function<bool()>& has,
                                        const std::function<std::string()>& problem,
                                        std::chrono::nanoseconds patience = std::chrono::seconds(5));

}  // namespace leitstand
