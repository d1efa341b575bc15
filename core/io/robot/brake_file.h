#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "core/base/result.h"
#include "core/station/preflight/brake_test.h"

namespace leitstand {

/// Reads the results of brake tests, which the station keeps between runs (YAML). The key is the robot. Empty
/// when the file is missing or invalid: then all robots count as untested.
[[nodiscard]] std::map<std::string, BrakeResult> readBrakes(const std::filesystem::path& file);
/// Replaces the stored results by @p results, completely or not at all. Errors name the file.
[[nodiscard]] Result<void> writeBrakes(const std::filesystem::path& file,
                                       const std::map<std::string, BrakeResult>& results);

}  // namespace leitstand
