#pragma once

#include <chrono>
#include <functional>
#include <string>

#include "core/base/result.h"

namespace leitstand {

/// Waits until the mission @p has what was published last. Errors, in words: the @p problem of its log, or
/// that it is not there after @p patience, when nobody knows whether it was written.
[[nodiscard]] Result<void> untilWritten(const std::function<bool()>& has,
                                        const std::function<std::string()>& problem,
                                        std::chrono::nanoseconds patience = std::chrono::seconds(5));

}  // namespace leitstand
