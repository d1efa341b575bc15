#pragma once

#include <filesystem>
#include <optional>

#include "core/base/result.h"
#include "core/settings/last_station.h"

namespace leitstand {

/// What @p file (YAML) remembers; nothing when it is not there or makes no sense.
[[nodiscard]] std::optional<LastStation> readLastStation(const std::filesystem::path& file);
/// Keeps @p station instead of what was. Errors name the file.
[[nodiscard]] Result<void> writeLastStation(const std::filesystem::path& file, const LastStation& station);

}  // namespace leitstand
