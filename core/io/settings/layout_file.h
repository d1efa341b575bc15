#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/settings/window_layout.h"

namespace leitstand {

/// Reads a layout (YAML; docs/operator.md lists the keys). Its name is the file's. Errors name file, line,
/// key and what was expected, a line for each.
[[nodiscard]] Result<WindowLayout> readLayout(const std::filesystem::path& file);
/// The same from @p text; errors call it @p name.
[[nodiscard]] Result<WindowLayout> parseLayout(std::string_view text, const std::string& name);

/// @p layout as a file that parseLayout() takes.
[[nodiscard]] std::string writeLayout(const WindowLayout& layout);
/// Puts it into @p file, whole or not at all; errors name the file.
Result<void> saveLayout(const WindowLayout& layout, const std::filesystem::path& file);

}  // namespace leitstand
