#pragma once

#include <filesystem>
#include <string>

namespace leitstand {

/// Returns @p text with the paths of a mission's files made relative to its folder. @p mission: that folder,
/// or a file in it. So the text of a report does not depend on where the mission is and how its path was
/// written.
[[nodiscard]] std::string namedWithin(std::string text, const std::filesystem::path& mission);

}  // namespace leitstand
