#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/settings/window_layout.h"

namespace leitstand {

/// Reads a layout (YAML; docs/layouts-and-settings.md lists the keys). The layout has the name of its file.
/// The error has a line for each mistake: file, line, key and what was expected.
[[nodiscard]] Result<WindowLayout> readLayout(const std::filesystem::path& file);
/// Parses the @p text of a layout; errors call the file @p name.
[[nodiscard]] Result<WindowLayout> parseLayout(std::string_view text, const std::string& name);

/// Returns @p layout as a file that parseLayout() accepts.
[[nodiscard]] std::string writeLayout(const WindowLayout& layout);
/// Writes @p layout to @p file, completely or not at all. Errors name the file.
Result<void> saveLayout(const WindowLayout& layout, const std::filesystem::path& file);

}  // namespace leitstand
