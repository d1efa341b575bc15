#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace leitstand {

/// Returns the folders in which robots' files are looked up by name. First the user's
/// (`$XDG_CONFIG_HOME/leitstand/robots`, else `~/.config/leitstand/robots`). Then those that come with the
/// program (`$LEITSTAND_RESOURCES/robots`, else ../share/leitstand/robots beside the binary).
[[nodiscard]] std::vector<std::filesystem::path> robotFolders();

/// Returns the names of the robots in @p folders, such as "kurt3d".
[[nodiscard]] std::vector<std::string> shippedRobots(
    const std::vector<std::filesystem::path>& folders = robotFolders());

/// Returns the file that @p nameOrPath means. It is a path when something exists there, or when it looks like
/// one (with a slash, or .yaml or .yml at its end). Otherwise it is a name: the file is NAME.yaml in the
/// first of @p folders that has it. Error when none has it; the error lists the known names.
[[nodiscard]] Result<std::filesystem::path> findRobotFile(
    const std::string& nameOrPath, const std::vector<std::filesystem::path>& folders = robotFolders());

}  // namespace leitstand
