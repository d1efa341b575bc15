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

/// A file of a bag, and where its rows are in the sequence of the bag.
struct BagPart {
    std::filesystem::path path{};
    std::shared_ptr<BagFile> file{};
    std::uint64_t offset = 0;   ///< sequence = id + offset
    bool live = false;          ///< whether a writer has it open
    bool damaged = false;       ///< whether it is read page by page, since SQLite cannot read it
    std::uint64_t missing = 0;  ///< number of messages that were counted but are not in the file
};

/// A bag with all its files open.
struct OpenBag {
    std::filesystem::path path{};
    std::vector<BagPart> parts{};
    std::optional<BagMetadata> metadata{};  ///< content of metadata.yaml
    std::vector<std::string> problems{};
};

/// Who may be writing a bag while it is opened.
enum class Writer : std::uint8_t {
    Anyone,  ///< anyone who holds the folder's lock
    Nobody   ///< nobody: the caller holds the lock and does not write yet
};

/// Opens the folder of a bag or one file of it; see BagReader::open().
[[nodiscard]] Result<OpenBag> openBag(const std::filesystem::path& bag, Writer writer = Writer::Anyone);

/// Sets how many messages of @p part are missing, according to its own metadata and to metadata.yaml. Returns
/// a text that reports them; empty when none are missing.
[[nodiscard]] std::string judgeMissing(BagPart& part, const std::optional<BagMetadata>& metadata);

/// Opens @p path with SQLite. If SQLite cannot read all of it, opens it page by page and sets @p damaged.
/// Adds faults of its write-ahead log to @p problems.
[[nodiscard]] Result<std::shared_ptr<BagFile>> openFile(const std::filesystem::path& path, bool live,
                                                        std::vector<std::string>& problems, bool& damaged);

}  // namespace leitstand::detail
