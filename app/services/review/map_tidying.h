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
    std::string version;  ///< of the program, for the session that is written
};

/// Result of a tidying.
struct TidiedMap {
    std::size_t scans = 0;  ///< in the map
    std::size_t moved = 0;  ///< those that moved noticeably
    /// Links that were written because scans had none, as in missions before version 0.2; 0: no scan lacked
    /// links.
    std::size_t linked = 0;
    Relaxation relaxation;
};

/// Makes all scans of the map of @p mission that overlap fit each other, whenever they were taken (relax()).
/// Writes their new links and poses as a session of the mission; what was recorded stays as it is. Error when
/// the mission has no map of ours or cannot be written. Error also when cancelled: nothing is written then.
[[nodiscard]] Result<TidiedMap> tidyMap(const std::filesystem::path& mission,
                                        const TidySettings& settings = {}, const Progress& progress = {});

/// Takes back the newest tidying that is not taken back: scans and links are then as before it. Error when
/// there is none, or when the map has changed since.
[[nodiscard]] Result<void> untidyMap(const std::filesystem::path& mission, const std::string& version);

/// Returns the result of a tidying in words, for the operator.
[[nodiscard]] std::string tidiedText(const TidiedMap& tidied);

/// Returns, by id, the poses that scans had before the newest tidying moved them. @p finished: the state at
/// the mission's end, for which canUntidy() is true.
[[nodiscard]] std::map<std::uint64_t, Pose> posesBeforeTidying(MissionState finished);

/// Whether untidyMap() can take something back in a mission that ended as @p finished.
[[nodiscard]] bool canUntidy(const MissionState& finished);

}  // namespace leitstand
