#pragma once

#include <string>

namespace leitstand {

struct BrakeResult;

/// For the log, in English: "brake test passed: it stood after 310 ms and 2 cm".
[[nodiscard]] std::string toString(const BrakeResult& result);
/// What toString() made of a result, in the window's language; anything else as it is.
[[nodiscard]] std::string brakeWorded(const std::string& said);

}  // namespace leitstand
