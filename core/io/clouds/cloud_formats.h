#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/io/clouds/scan_reading.h"

namespace leitstand {

/// A file format for a single cloud.
struct CloudFormat {
    std::string_view ending;  ///< ending with its dot, in lower case
    Result<ScanReading> (*read)(const std::filesystem::path& file);
    /// Null when the format can only be read.
    Result<void> (*write)(const std::filesystem::path& file, const Scan& cloud) = nullptr;
};

/// Returns all formats that are read or written.
[[nodiscard]] std::span<const CloudFormat> cloudFormats();
/// Returns the format by the ending of @p file, in lower or upper case; null when no format has it.
[[nodiscard]] const CloudFormat* cloudFormatOf(const std::filesystem::path& file);

/// Which formats to list.
enum class CloudEndings : std::uint8_t { All, Written };
/// Lists the endings of the formats for people. With @p between ", " and @p last " or ", that is ".pcd, .ply
/// or .xyz".
[[nodiscard]] std::string listOf(CloudEndings which, std::string_view between = " ",
                                 std::string_view last = " ");

}  // namespace leitstand
