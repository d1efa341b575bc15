#pragma once

#include <cstdint>
#include <filesystem>

#include "core/base/result.h"
#include "core/io/bag/detail/bag_metadata.h"

namespace leitstand::detail {

/// What a mission's folder holds before a session begins.
struct EarlierSessions {
    BagMetadata metadata;            ///< their files, topics and counts, as far as they can be read
    std::uint64_t lastSequence = 0;  ///< 0: no events
    std::filesystem::path nextFile;  ///< of the session that begins
};

/// Looks into @p folder, changing nothing. Sessions that cannot be read are no error; a bag of others is one,
/// since the next session would write over its metadata.
[[nodiscard]] Result<EarlierSessions> earlierSessions(const std::filesystem::path& folder);

}  // namespace leitstand::detail
