#pragma once

#include <filesystem>
#include <optional>

#include "core/base/result.h"
#include "core/settings/last_station.h"

namespace leitstand {

/// Reads the station stored in @p file (YAML); empty when the file is missing or invalid.
[[nodiscard]] std::optional<LastStation> readLastStation(const std::filesystem::path& file);
/// Replaces the stored station by @p station. Errors name the file.
[[nodiscard]] Result<void> writeLastStation(const std::filesystem::path& file, const LastStation& station);

}  // namespace leitstand
