#pragma once

#include <filesystem>
#include <optional>

#include "core/settings/last_station.h"

namespace leitstand {

/// With what the station was opened last, as @p file remembers it; nothing when it never was.
[[nodiscard]] std::optional<LastStation> lastStation(const std::filesystem::path& file);
/// Remembers it; what cannot be written is asked for again next time.
void rememberStation(const std::filesystem::path& file, const LastStation& station);

}  // namespace leitstand
