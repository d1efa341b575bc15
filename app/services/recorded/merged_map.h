#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mapping/live/live_settings.h"
#include "core/mapping/relocalisation/relocaliser.h"

namespace leitstand {

/// Two missions whose maps come into one.
struct MergeOrder {
    std::filesystem::path first, second;  ///< stay as they are; which of them began first is found out
    std::filesystem::path into;           ///< a new mission: absent, or empty
    LiveSettings mapping;
    RelocalisationSettings relocalisation;
    std::string version;  ///< of the program, for the sessions that are written
};

/// What came of it.
struct MergedMap {
    std::size_t first = 0, second = 0;  ///< key scans of the earlier and of the later mission
    std::size_t sought = 0, found = 0;  ///< of the second, in the first: PartsMeeting
    std::size_t agreeing = 0;           ///< of those
    bool together = false;              ///< the two are one map now
    std::size_t aside = 0;              ///< of the later one, in parts that are not in it
};

/// Writes the maps of two missions into a new one, and puts the later one (the largest part of it, where it
/// is in parts) where scans of it see what the earlier one has: three places at least that agree, with all of
/// it compared by what the earlier one looked through. Where that is not known for sure it lies beside the
/// earlier one as a part of its own, for somebody to show its place. Errors name the mission: it has no map
/// of ours, or that of @p order is there already, or it was cancelled; nothing is left of the new one then.
[[nodiscard]] Result<MergedMap> mergeMaps(const MergeOrder& order, const Progress& progress = {});

}  // namespace leitstand
