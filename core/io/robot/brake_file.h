#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "core/base/result.h"
#include "core/station/preflight/brake_test.h"

namespace leitstand {

/// Reads the results of brake tests by robot, which the station keeps between runs (YAML). Empty when the
/// file is missing or invalid: robots are untested then.
[[nodiscard]] std::map<std::string, BrakeResult> readBrakes(const std::filesystem::path& file);
/// Replaces the stored results by @p results; the file is never half written. Errors name the file.
[[nodiscard]] Result<void> writeBrakes(const std::filesystem::path& file,
                                       const std::map<std::string, BrakeResult>& results);

}  // namespace leitstand
