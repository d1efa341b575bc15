#pragma once

#include <cstdint>
#include <filesystem>

#include <QString>

namespace leitstand {

/// What shall be done to the map of a mission that has ended: tidy it, or undo the newest tidying.
enum class MapTidying : std::uint8_t { Tidy, TakeBack };

/// Result of tidyInFront().
struct TidyingOutcome {
    bool moved = false;  ///< whether scans were moved
    QString text;        ///< result in words
};

/// Tidies the map of @p mission, or undoes the newest tidying. A window shows the progress and can cancel
/// tidying. Nobody may have the mission open for writing during this time.
[[nodiscard]] TidyingOutcome tidyInFront(const std::filesystem::path& mission, MapTidying what);

}  // namespace leitstand
