#pragma once

#include <filesystem>
#include <optional>

#include "core/settings/last_station.h"

namespace leitstand {

/// Returns the settings with which the station was opened last, as stored in @p file; empty: none are.
[[nodiscard]] std::optional<LastStation> lastStation(const std::filesystem::path& file);
/// Stores @p station in @p file; if that fails, the user is asked again next time.
void rememberStation(const std::filesystem::path& file, const LastStation& station);

}  // namespace leitstand
