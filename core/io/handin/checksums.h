#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace leitstand {

/// SHA-256 of a file's bytes in small hexadecimal digits.
[[nodiscard]] Result<std::string> sha256Of(const std::filesystem::path& file);

/// Writes `SHA256SUMS` in @p folder over @p names, files in it, in the format of `sha256sum`.
[[nodiscard]] Result<void> writeChecksums(const std::filesystem::path& folder,
                                          const std::vector<std::string>& names);

/// A line of a SHA256SUMS.
struct Checksum {
    std::string sum;   ///< 64 hexadecimal digits
    std::string name;  ///< of a file beside it
};
/// What @p folder's SHA256SUMS lists; nothing is compared.
[[nodiscard]] Result<std::vector<Checksum>> readChecksums(const std::filesystem::path& folder);

/// Compares every file that @p folder's SHA256SUMS lists; the names that are as listed, or what is not.
[[nodiscard]] Result<std::vector<std::string>> checkChecksums(const std::filesystem::path& folder);

}  // namespace leitstand
