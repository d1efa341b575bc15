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
    std::filesystem::path folder;          ///< absent or empty, unless a map is added to it
    std::vector<RobotDescription> robots;  ///< of its station
    std::string version;                   ///< of the program, for the session that is written
};

/// Returns the error that @p folder, into which a map is to be carried, already has content.
[[nodiscard]] Error isThere(const std::filesystem::path& folder);

/// Checks that carryMap() finds a map in the mission folder @p mission; the error explains why not. Reads
/// little of it.
[[nodiscard]] Result<void> hasMap(const std::filesystem::path& mission);

/// Writes the map of the mission @p from into the new mission of @p into, as a session of its own. Carries
/// the scans that count, with their poses and links, and the area that belongs into the map. The new mission
/// then no longer needs @p from, which stays as it is. The robots of the carried scans are called NAME@FOLDER
/// there. Robots of the new mission are placed only by what they see: they map parts of their own until a
/// place is found that both maps have seen. Finds, trails and what was searched are not carried. Returns the
/// number of scans that count. Errors name the mission: @p from has no map of ours, or the new folder has
/// content already. A new mission that is not whole is removed.
[[nodiscard]] Result<std::size_t> carryMap(const std::filesystem::path& from, const CarriedInto& into,
                                           const Progress& progress = {});

/// Adds the map of @p from to the mission of @p into, beside the map there, as a part of its own. The pose of
/// the two relative to each other is unknown. Only the area of the map that was there stays. Returns the
/// number of added scans that count. Error when @p from has no map, the mission cannot be written, or when
/// cancelled. The mission may then hold some of the scans.
[[nodiscard]] Result<std::size_t> addMap(const std::filesystem::path& from, const CarriedInto& into,
                                         const Progress& progress = {});

}  // namespace leitstand
