#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "core/base/result.h"
#include "core/io/bag/bag_storage.h"
#include "core/io/bag/detail/bag_metadata.h"

namespace leitstand::detail {

/// What a mission's folder holds from earlier sessions.
struct EarlierSessions {
    BagMetadata metadata;            ///< files, topics and counts of those sessions that could be read
    std::uint64_t lastSequence = 0;  ///< 0: the sessions have no events
    BagStorage storage = BagStorage::Sqlite;
    std::filesystem::path nextFile;  ///< file for the session that begins
};

/// Reads @p folder without changing it. Sessions that cannot be read are no error. A bag of another program
/// is an error, since the next session would overwrite its metadata. So are sessions in another kind of files
/// than @p storage: the metadata have one for all. Without @p storage, it is that of the earlier sessions.
[[nodiscard]] Result<EarlierSessions> earlierSessions(const std::filesystem::path& folder,
                                                      std::optional<BagStorage> storage);

}  // namespace leitstand::detail
