#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/io/bag/detail/bag_metadata.h"
#include "core/io/bag/reading/bag_file.h"

namespace leitstand::detail {

/// A file of a bag and the place of its rows in the sequence of the bag.
struct BagPart {
    std::filesystem::path path{};
    std::shared_ptr<BagFile> file{};
    std::uint64_t offset = 0;   ///< sequence = id + offset
    bool live = false;          ///< a writer has it open
    bool damaged = false;       ///< read page by page
    std::uint64_t missing = 0;  ///< messages that were counted but are not in the file
};

/// A bag with all its files open.
struct OpenBag {
    std::filesystem::path path{};
    std::vector<BagPart> parts{};
    std::optional<BagMetadata> metadata{};  ///< of metadata.yaml
    std::vector<std::string> problems{};
};

/// Who may be writing a bag while it is opened.
enum class Writer : std::uint8_t {
    Anyone,  ///< whoever holds the folder's lock
    Nobody   ///< the caller holds the lock and does not write yet
};

/// Opens the folder of a bag or one file of it; see BagReader::open().
[[nodiscard]] Result<OpenBag> openBag(const std::filesystem::path& bag, Writer writer = Writer::Anyone);

/// Sets how many messages of @p part are missing, by its own metadata and by metadata.yaml. Returns a text
/// that reports them; empty when none are missing.
[[nodiscard]] std::string judgeMissing(BagPart& part, const std::optional<BagMetadata>& metadata);

/// Opens @p path with SQLite, or page by page (@p damaged is set) when SQLite cannot read all of it. Adds
/// what is wrong with its write-ahead log to @p problems.
[[nodiscard]] Result<std::shared_ptr<BagFile>> openFile(const std::filesystem::path& path, bool live,
                                                        std::vector<std::string>& problems, bool& damaged);

}  // namespace leitstand::detail
