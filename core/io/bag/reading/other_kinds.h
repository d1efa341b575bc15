#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/event/raw_event.h"
#include "core/io/bag/detail/bag_metadata.h"
#include "core/io/bag/detail/mission_folder.h"

namespace leitstand::detail {

/// What a file with these first bytes is when it is a bag that we do not read ("an MCAP file"); empty when it
/// is none that we know.
[[nodiscard]] std::string otherKind(std::string_view begin);
/// The same of the file at @p path.
[[nodiscard]] std::string otherKindOf(const std::filesystem::path& path);
/// Whether @p cdr is no CDR but compressed by zstd, as rosbag2 does in its mode "message".
[[nodiscard]] bool isCompressed(const Payload& cdr);

/// An error when the bag in @p folder, which has @p files to read, is of a kind that we do not read; names
/// in @p problems what else the bag has or should have.
[[nodiscard]] Result<void> checkKind(const std::filesystem::path& folder,
                                     const std::optional<BagMetadata>& metadata,
                                     const std::vector<NumberedFile>& files,
                                     std::vector<std::string>& problems);

}  // namespace leitstand::detail
