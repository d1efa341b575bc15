#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "core/base/result.h"
#include "core/station/preflight/brake_test.h"

namespace leitstand {

/// Results of brake tests by robot, as the station remembers them from run to run (YAML). A file that is not
/// there, or makes no sense, tells of no test: robots are untested then.
[[nodiscard]] std::map<std::string, BrakeResult> readBrakes(const std::filesystem::path& file);
/// Keeps @p results instead of what was; the file is never half written. Errors name it.
[[nodiscard]] Result<void> writeBrakes(const std::filesystem::path& file,
                                       const std::map<std::string, BrakeResult>& results);

}  // namespace leitstand
