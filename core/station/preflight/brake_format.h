#pragma once

#include <string>

namespace leitstand {

struct BrakeResult;

/// Returns the result for the log, in English: "brake test passed: it stood after 310 ms and 2 cm".
[[nodiscard]] std::string toString(const BrakeResult& result);
/// Translates what toString() made of a result into the window's language; returns any other text as it is.
[[nodiscard]] std::string brakeWorded(const std::string& reported);

}  // namespace leitstand
