#pragma once

#include <cstdint>
#include <filesystem>

#include <QString>

namespace leitstand {

/// What is done to the map of a mission that has ended.
enum class MapTidying : std::uint8_t { Tidy, TakeBack };

/// What came of it.
struct TidyingOutcome {
    bool moved = false;  ///< scans are elsewhere now
    QString text;        ///< in words
};

/// Does it in front of a window that tells how far it is and cancels it. Nobody may have the @p mission open
/// for writing meanwhile.
[[nodiscard]] TidyingOutcome tidyInFront(const std::filesystem::path& mission, MapTidying what);

}  // namespace leitstand
