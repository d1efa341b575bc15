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

/// Whether the file at @p path is a bag of ROS 1.
[[nodiscard]] bool isRos1(const std::filesystem::path& path);
/// Whether the file at @p path is compressed by zstd.
[[nodiscard]] bool isPacked(const std::filesystem::path& path);
/// Whether the file at @p path is to be read as MCAP: by its first bytes, or by its ending.
[[nodiscard]] bool isMcap(const std::filesystem::path& path);
/// Whether @p cdr is not plain CDR but compressed by zstd, as by rosbag2 in its mode "message".
[[nodiscard]] bool isCompressed(const Payload& cdr);

/// Checks that the bag in @p folder, with the database files @p files, is of a supported kind; otherwise
/// error. Adds files that are not read or are missing to @p problems.
[[nodiscard]] Result<void> checkKind(const std::filesystem::path& folder,
                                     const std::optional<BagMetadata>& metadata,
                                     const std::vector<NumberedFile>& files,
                                     std::vector<std::string>& problems);

}  // namespace leitstand::detail
