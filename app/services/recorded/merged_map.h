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
    std::filesystem::path first, second;  ///< stay unchanged; in any order
    std::filesystem::path into;           ///< a new mission: absent, or empty
    LiveSettings mapping;
    RelocalisationSettings relocalisation;
    std::string version;  ///< of the program, for the sessions that are written
};

/// Result of a merge.
struct MergedMap {
    std::size_t first = 0, second = 0;  ///< key scans of the earlier and of the later mission
    std::size_t sought = 0,
                found = 0;     ///< scans of the later mission that were sought, and found, in the earlier one
    std::size_t agreeing = 0;  ///< found scans whose places agree
    bool together = false;     ///< the two maps are one now
    std::size_t aside = 0;     ///< scans of the later one, in parts that have not met the earlier one
};

/// Writes the maps of two missions into a new one. Places the later map (its largest part, if it has parts)
/// where its scans see what the earlier map has. At least three places must agree, and the placed part must
/// stand in little that the earlier map saw as free. Otherwise the later map lies beside the earlier one as a
/// part of its own, for an operator to place. Errors name the mission: it has no map of ours, both are the
/// same, or the new folder has content already. Also an error when cancelled. A new mission that is not whole
/// is removed.
[[nodiscard]] Result<MergedMap> mergeMaps(const MergeOrder& order, const Progress& progress = {});

}  // namespace leitstand
