#pragma once

#include <filesystem>
#include <optional>

#include "core/settings/last_station.h"

namespace leitstand {

/// Returns with what the station was opened last, as stored in @p file; empty when it never was.
[[nodiscard]] std::optional<LastStation> lastStation(const std::filesystem::path& file);
/// Stores @p station; what cannot be written is asked for again next time.
void rememberStation(const std::filesystem::path& file, const LastStation& station);

}  // namespace leitstand
