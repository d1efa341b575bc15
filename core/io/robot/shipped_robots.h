#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace leitstand {

/// Returns the folders in which robots' files are looked up by name. The first is the user's:
/// `$XDG_CONFIG_HOME/leitstand/robots`, or ~/.config/leitstand/robots without that variable. The second comes
/// with the program: `$LEITSTAND_RESOURCES/robots`, or ../share/leitstand/robots beside the binary.
[[nodiscard]] std::vector<std::filesystem::path> robotFolders();

/// Returns the names of the robots in @p folders, such as "kurt3d".
[[nodiscard]] std::vector<std::string> shippedRobots(
    const std::vector<std::filesystem::path>& folders = robotFolders());

/// Returns the file that @p nameOrPath means. It is a path when something exists there, or when it looks like
/// a path (with a slash, or .yaml or .yml at its end). Otherwise it is a name: the file is NAME.yaml in the
/// first of @p folders that contains it. Error, with the known names, when no folder contains it.
[[nodiscard]] Result<std::filesystem::path> findRobotFile(
    const std::string& nameOrPath, const std::vector<std::filesystem::path>& folders = robotFolders());

}  // namespace leitstand
