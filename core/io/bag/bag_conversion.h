#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/io/bag/bag_storage.h"

namespace leitstand {

class BagReader;

/// The outcome of convertBag().
struct BagConversion {
    std::uint64_t messages = 0;         ///< that were written
    std::vector<std::string> problems;  ///< of the source, and what the copy does not keep
};

/// Whether @p bag is a copy of a mission in MCAP that lacks the sequences of its messages, by which undos and
/// finds name others. Other programs make such copies; nothing can be folded from them.
[[nodiscard]] bool isCopyOfMission(const BagReader& bag);

/// Copies the messages of @p bag with their topics into a new bag: the folder @p out, which may not exist
/// yet. What stands beside the log (robot files, kept pictures) is copied, too. Errors: the source
/// cannot be opened; it is a copy of a mission and is to become a database; the copy cannot be written. Then,
/// and when cancelled, nothing stays.
[[nodiscard]] Result<BagConversion> convertBag(const std::filesystem::path& bag,
                                               const std::filesystem::path& out, BagStorage storage,
                                               const Progress& progress = {});

}  // namespace leitstand
