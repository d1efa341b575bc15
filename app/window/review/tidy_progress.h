#pragma once

#include <cstdint>
#include <filesystem>

#include <QString>

namespace leitstand {

/// What is done to the map of a mission that has ended.
enum class MapTidying : std::uint8_t { Tidy, TakeBack };

/// Outcome of tidyInFront().
struct TidyingOutcome {
    bool moved = false;  ///< scans were moved
    QString text;        ///< outcome in words
};

/// Tidies the map of @p mission, or takes that back. A window shows the progress and can cancel tidying.
/// Nobody may have the mission open for writing meanwhile.
[[nodiscard]] TidyingOutcome tidyInFront(const std::filesystem::path& mission, MapTidying what);

}  // namespace leitstand
