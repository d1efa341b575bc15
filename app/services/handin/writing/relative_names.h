#pragma once

#include <filesystem>
#include <string>

namespace leitstand {

/// @p text with the files of @p mission, a folder or a file in one, called as they are within the folder:
/// what a report tells of a mission is the same wherever it lies and however it was named.
[[nodiscard]] std::string namedWithin(std::string text, const std::filesystem::path& mission);

}  // namespace leitstand
