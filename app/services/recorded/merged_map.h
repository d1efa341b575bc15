#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mapping/live/live_settings.h"
#include "core/mapping/relocalisation/relocaliser.h"

namespace leitstand {

/// Two missions whose maps are merged into one.
struct MergeOrder {
    std::filesystem::path first, second;  ///< stay unchanged; which of them began first is found out
    std::filesystem::path into;           ///< a new mission: absent, or empty
    LiveSettings mapping;
    RelocalisationSettings relocalisation;
    std::string version;  ///< of the program, for the sessions that are written
};

/// Result of a merge.
struct MergedMap {
    std::size_t first = 0, second = 0;  ///< key scans of the earlier and of the later mission
    std::size_t sought = 0, found = 0;  ///< scans of the second, sought and found in the first: PartsMeeting
    std::size_t agreeing = 0;           ///< of those found
    bool together = false;              ///< the two are one map now
    std::size_t aside = 0;              ///< scans of the later one, in parts that are not in the first
};

/// Writes the maps of two missions into a new one. Places the later one (its largest part, if it has parts)
/// where its scans see what the earlier one has. At least three places must agree, and all of it is compared
/// with what the earlier one looked through. If that place is not certain, the later one lies beside the
/// earlier one as its own part, for somebody to place. Errors name the mission: it has no map of ours, that
/// of @p order exists already, or it was cancelled. Nothing of the new one is left then.
[[nodiscard]] Result<MergedMap> mergeMaps(const MergeOrder& order, const Progress& progress = {});

}  // namespace leitstand
