#pragma once

#include <cstdint>
#include <filesystem>

#include <QString>

namespace leitstand {

/// What is done to the map of a mission that has ended.
enum class MapTidying : std::uint8_t { Tidy, TakeBack };

/// Does it in front of a window that tells how far it is and cancels it; what came of it, in words. Nobody
/// may have the @p mission open for writing meanwhile.
[[nodiscard]] QString tidyInFront(const std::filesystem::path& mission, MapTidying what);

}  // namespace leitstand
