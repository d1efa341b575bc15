#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace leitstand {

/// Folders in which robots' files are looked for by name: the user's (`$XDG_CONFIG_HOME/leitstand/robots`,
/// else
/// `~/.config/leitstand/robots`), then those that come with the program (`$LEITSTAND_RESOURCES/robots`, else
/// ../share/leitstand/robots beside the binary).
[[nodiscard]] std::vector<std::filesystem::path> robotFolders();

/// Names of the robots in @p folders, "kurt3d".
[[nodiscard]] std::vector<std::string> shippedRobots(
    const std::vector<std::filesystem::path>& folders = robotFolders());

/// The file that @p nameOrPath means: a path when something is there or when it looks like one (a slash, or
/// .yaml at its end); otherwise NAME.yaml in the first of @p folders that has it. The error lists the names
/// that there are.
[[nodiscard]] Result<std::filesystem::path> findRobotFile(
    const std::string& nameOrPath, const std::vector<std::filesystem::path>& folders = robotFolders());

}  // namespace leitstand
