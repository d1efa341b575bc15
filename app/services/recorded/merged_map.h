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
    std::filesystem::path first, second;  ///< missions to merge, in any order; they are not changed
    std::filesystem::path into;           ///< new mission: missing or empty
    LiveSettings mapping;
    RelocalisationSettings relocalisation;
    std::string version;  ///< version of the program, for the sessions that are written
};

/// Result of a merge.
struct MergedMap {
    std::size_t first = 0, second = 0;  ///< number of key scans of the earlier and of the later mission
    std::size_t sought = 0,
                /// Number of scans of the later mission that were looked for, and found, in the earlier one.
        found = 0;
    std::size_t agreeing = 0;  ///< number of found scans whose places agree
    bool together = false;     ///< whether the two maps are joined now
    /// Number of the later mission's scans in parts that are not joined with the earlier map.
    std::size_t aside = 0;
};

/// Writes the maps of two missions to a new one. Places the later map (if it has parts, the largest part)
/// where its scans see what the earlier map shows. At least three places must agree, and hardly any of the
/// placed part may stand where the earlier map saw free space. Otherwise the later map is put beside the
/// earlier one as a separate part, which an operator can place. Errors name the mission: it has no map by
/// Leitstand, both are the same, or the new folder is not empty. Also an error when cancelled. An incomplete
/// new mission is removed.
[[nodiscard]] Result<MergedMap> mergeMaps(const MergeOrder& order, const Progress& progress = {});

}  // namespace leitstand
