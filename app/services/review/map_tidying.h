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

/// What came of it.
struct TidiedMap {
    std::size_t scans = 0;  ///< of the map
    std::size_t moved = 0;  ///< of them noticeably
    /// Links that were made, where scans had none: those of missions of before version 0.2.
    std::size_t linked = 0;
    Relaxation relaxation;
};

/// Relaxes all scans of the map of @p mission that overlap, whenever they were taken, and writes what holds
/// them now and where they stand as a session of the mission: what was recorded stays as it is. Errors: the
/// mission has no map of ours, cannot be written, or was cancelled, when nothing was written.
[[nodiscard]] Result<TidiedMap> tidyMap(const std::filesystem::path& mission,
                                        const TidySettings& settings = {}, const Progress& progress = {});

/// Takes back the newest tidying that is not taken back: scans and links are as before it. An error where
/// there is none.
[[nodiscard]] Result<void> untidyMap(const std::filesystem::path& mission, const std::string& version);

/// What @p tidied came to, for the operator.
[[nodiscard]] std::string tidiedText(const TidiedMap& tidied);

/// Where the scans that the newest tidying moved, which canUntidy(), stood before it in a mission that ended
/// as @p finished; by id.
[[nodiscard]] std::map<std::uint64_t, Pose> posesBeforeTidying(MissionState finished);

/// Whether untidyMap() has something to take back of a mission that ended as @p finished.
[[nodiscard]] bool canUntidy(const MissionState& finished);

}  // namespace leitstand
