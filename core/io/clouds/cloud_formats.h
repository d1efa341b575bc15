#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/io/clouds/scan_reading.h"

namespace leitstand {

/// A format of files that hold one cloud.
struct CloudFormat {
    std::string_view ending;  ///< with its dot, in small letters
    Result<ScanReading> (*read)(const std::filesystem::path& file);
    /// Null: it is read only, a map is not written so.
    Result<void> (*write)(const std::filesystem::path& file, const Scan& cloud) = nullptr;
};

/// All that are read or written.
[[nodiscard]] std::span<const CloudFormat> cloudFormats();
/// By the ending of @p file, in small or capital letters; null: it has none of them.
[[nodiscard]] const CloudFormat* cloudFormatOf(const std::filesystem::path& file);

/// Which endings are listed.
enum class CloudEndings : std::uint8_t { All, Written };
/// Of the formats, as for people: ".pcd, .ply or .xyz" by ", " and " or ".
[[nodiscard]] std::string listOf(CloudEndings which, std::string_view between = " ",
                                 std::string_view last = " ");

}  // namespace leitstand
