#pragma once

#include <cstdint>
#include <string_view>

namespace leitstand {

/// In which kind of files a bag stores its messages.
enum class BagStorage : std::uint8_t { Sqlite, Mcap };

/// rosbag2's name of @p storage, as metadata.yaml and command lines have it.
[[nodiscard]] constexpr std::string_view nameOf(BagStorage storage) {
    return storage == BagStorage::Mcap ? "mcap" : "sqlite3";
}
/// How the names of files of @p storage end.
[[nodiscard]] constexpr std::string_view endingOf(BagStorage storage) {
    return storage == BagStorage::Mcap ? ".mcap" : ".db3";
}

}  // namespace leitstand
