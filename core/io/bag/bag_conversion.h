#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"

namespace leitstand {

/// How a bag stores its messages.
enum class BagStorage : std::uint8_t { Sqlite, Mcap };

/// The outcome of convertBag().
struct BagConversion {
    std::uint64_t messages = 0;         ///< that were written
    std::vector<std::string> problems;  ///< of the source, and what the copy does not keep
};

/// Copies the messages of @p bag with their topics into a new bag: the folder @p out, which may not exist
/// yet. What stands beside the log (robot files, kept pictures) is copied, too. In an MCAP file messages have
/// no numbers: what a mission of ours undoes by number does not stay undone there. Error when the source
/// cannot be opened or the copy not written; then, and when cancelled, nothing stays.
[[nodiscard]] Result<BagConversion> convertBag(const std::filesystem::path& bag,
                                               const std::filesystem::path& out, BagStorage storage,
                                               const Progress& progress = {});

}  // namespace leitstand
