#pragma once

#include <chrono>
#include <functional>
#include <string>

#include "core/base/result.h"

namespace leitstand {

/// Waits until @p has returns true: the mission then has what was published last. Errors, in words: the log's
/// fault, which @p problem returns, or that @p patience is over. In the second case it is unknown whether it
/// was written.
[[nodiscard]] Result<void> untilWritten(const std::function<bool()>& has,
                                        const std::function<std::string()>& problem,
                                        std::chrono::nanoseconds patience = std::chrono::seconds(5));

}  // namespace leitstand
