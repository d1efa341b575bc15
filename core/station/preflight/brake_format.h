#pragma once

#include <string>

namespace leitstand {

struct BrakeResult;

/// Returns the result for the log: "brake_passed stood_ms=310 way_cm=2".
[[nodiscard]] std::string toString(const BrakeResult& result);
/// Returns @p reported, a text from toString(), in the window's language. Any other text is not changed. Also
/// reads the English sentences of old logs, from before there were codes.
[[nodiscard]] std::string brakeWorded(const std::string& reported);

}  // namespace leitstand
