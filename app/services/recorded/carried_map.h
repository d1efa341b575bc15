#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/robot/robot_description.h"

namespace leitstand {

/// The mission that a map is carried into.
struct CarriedInto {
    std::filesystem::path folder;          ///< absent, or empty, where it is not to be added to
    std::vector<RobotDescription> robots;  ///< of its station
    std::string version;                   ///< of the program, for the session that is written
};

/// The error that something is written into @p folder already, where a map is to be carried.
[[nodiscard]] Error isThere(const std::filesystem::path& folder);

/// Whether carryMap() finds a map in the mission folder @p mission; else why not. Reads little of it.
[[nodiscard]] Result<void> hasMap(const std::filesystem::path& mission);

/// Writes the map of the mission @p from into that of @p into, as a session of its own: its scans that count,
/// as they stand, what they were registered against, and the area that belongs into the map. That mission
/// then needs @p from no more, which stays as it is. Its robots are called NAME@FOLDER there, so that where
/// those of the new mission stand is told by nothing but what they see: they map parts of their own until a
/// place is found that both have seen. Finds, trails and what was searched are not carried. Returns how many
/// scans. Errors name the mission: it has no map of ours, or that of @p into is there already; nothing is
/// left of that then.
[[nodiscard]] Result<std::size_t> carryMap(const std::filesystem::path& from, const CarriedInto& into,
                                           const Progress& progress = {});

/// The same beside the map that the mission of @p into has already, as a part of its own: of which it is not
/// known how it lies to that. Only the area of the first one stays. Errors: it has no map, or cannot be
/// written; the mission is as it was then, but for a session that adds nothing.
[[nodiscard]] Result<std::size_t> addMap(const std::filesystem::path& from, const CarriedInto& into,
                                         const Progress& progress = {});

}  // namespace leitstand
