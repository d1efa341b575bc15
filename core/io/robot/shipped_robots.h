#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace leitstand {

/// Names of the robots whose files come with the program, "kurt3d"; from ../share/leitstand/robots beside the
/// binary, or $LEITSTAND_RESOURCES/robots.
[[nodiscard]] std::vector<std::string> shippedRobots();

/// The file that @p nameOrPath means: a path, or the bare name of a shipped robot. The error lists those.
[[nodiscard]] Result<std::filesystem::path> findRobotFile(const std::string& nameOrPath);

}  // namespace leitstand
