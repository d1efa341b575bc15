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

/// A file of a bag and where its rows stand in the bag's sequence.
struct BagPart {
    std::filesystem::path path{};
    std::shared_ptr<BagFile> file{};
    std::uint64_t offset = 0;  ///< sequence = id + offset
    bool live = false;         ///< a writer has it
    bool damaged = false;      ///< read page by page
};

/// A bag with all its files open.
struct OpenBag {
    std::filesystem::path path{};
    std::vector<BagPart> parts{};
    std::optional<BagMetadata> metadata{};  ///< of metadata.yaml
    std::vector<std::string> problems{};
};

/// Opens a bag's folder or one file of it, as BagReader::open() tells.
[[nodiscard]] Result<OpenBag> openBag(const std::filesystem::path& bag);

/// Opens @p path by SQLite or, where that cannot read it, page by page (@p damaged is set).
[[nodiscard]] Result<std::shared_ptr<BagFile>> openFile(const std::filesystem::path& path, bool live,
                                                        bool& damaged);

}  // namespace leitstand::detail
