#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace leitstand {

/// Returns the SHA-256 of a file's bytes in lower-case hexadecimal digits.
[[nodiscard]] Result<std::string> sha256Of(const std::filesystem::path& file);

/// Writes `SHA256SUMS` in @p folder for the files called @p names, in the format of `sha256sum`.
[[nodiscard]] Result<void> writeChecksums(const std::filesystem::path& folder,
                                          const std::vector<std::string>& names);

/// A line of a file SHA256SUMS.
struct Checksum {
    std::string sum;   ///< 64 hexadecimal digits
    std::string name;  ///< name of a file in the same folder
};
/// Reads the SHA256SUMS of @p folder. The files that it lists are not checked.
[[nodiscard]] Result<std::vector<Checksum>> readChecksums(const std::filesystem::path& folder);

/// Checks every file that the SHA256SUMS of @p folder lists. Returns the names of the files. Error when a
/// file differs from its checksum.
[[nodiscard]] Result<std::vector<std::string>> checkChecksums(const std::filesystem::path& folder);

}  // namespace leitstand
