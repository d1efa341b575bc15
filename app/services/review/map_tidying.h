#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mapping/live/live_settings.h"
#include "core/mapping/relaxation/relaxation.h"
#include "core/mission/state/mission_state.h"

namespace leitstand {

/// How the map of a mission is tidied.
struct TidySettings {
    LiveSettings mapping;
    RelaxationSettings relaxation;
    std::string version;  ///< version of the program, for the session that is written
};

/// Result of tidying a map.
struct TidiedMap {
    std::size_t scans = 0;  ///< number of scans in the map
    std::size_t moved = 0;  ///< number of scans that moved noticeably
    /// Number of links that were written because scans had none, as in missions before version 0.2.
    std::size_t linked = 0;
    Relaxation relaxation;
};

/// Fits all overlapping scans of the map of @p mission to each other, whenever they were taken (relax()).
/// Writes their new links and poses as a new session of the mission; what was recorded is not changed. Error
/// when the mission has no map by Leitstand or cannot be written. Also an error when cancelled; then nothing
/// is written.
[[nodiscard]] Result<TidiedMap> tidyMap(const std::filesystem::path& mission,
                                        const TidySettings& settings = {}, const Progress& progress = {});

/// Undoes the newest tidying that is not undone. Scans and links are then as they were before it. Error when
/// there is none, or when the map has changed since.
[[nodiscard]] Result<void> untidyMap(const std::filesystem::path& mission, const std::string& version);

/// Returns the result of a tidying in words, for the operator.
[[nodiscard]] std::string tidiedText(const TidiedMap& tidied);

/// Returns the poses that scans had before the newest tidying moved them, by id. @p finished: state at the
/// mission's end, for which canUntidy() must be true.
[[nodiscard]] std::map<std::uint64_t, Pose> posesBeforeTidying(MissionState finished);

/// Whether untidyMap() can undo something in a mission that ended in the state @p finished.
[[nodiscard]] bool canUntidy(const MissionState& finished);

}  // namespace leitstand
