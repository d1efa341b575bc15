#pragma once

#include <filesystem>
#include <string>

namespace leitstand {

/// Returns @p text with paths of files of @p mission, a folder or a file in one, relative to the folder. The
/// text of a report then does not depend on where the mission lies and how its path was written.
[[nodiscard]] std::string namedWithin(std::string text, const std::filesystem::path& mission);

}  // namespace leitstand
