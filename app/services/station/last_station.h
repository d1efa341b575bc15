#pragma once

#include <filesystem>
#include <optional>

#include "core/settings/last_station.h"

namespace leitstand {

/// Returns the settings with which the station was last opened, as stored in @p file; empty: none are stored.
[[nodiscard]] std::optional<LastStation> lastStation(const std::filesystem::path& file);
/// Stores @p station in @p file. If that fails, the user will be asked again next time.
void rememberStation(const std::filesystem::path& file, const LastStation& station);

}  // namespace leitstand
