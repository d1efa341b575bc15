#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "robots/simulation/arena/arena.h"

namespace leitstand::simulation {

/// Reads an arena file (YAML; docs/simulation.md lists the keys). The error has a line for each mistake:
/// file, line, key and what was expected.
[[nodiscard]] Result<Arena> readArena(const std::filesystem::path& file);
/// Parses an arena from @p text; errors call the file @p name.
[[nodiscard]] Result<Arena> parseArena(std::string_view text, const std::string& name);
/// Returns @p arena as a file from which parseArena() reads an equal arena.
[[nodiscard]] std::string writeArena(const Arena& arena);

}  // namespace leitstand::simulation
