#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/robot/robot_description.h"

namespace leitstand {

/// The mission into which a map is carried.
struct CarriedInto {
    std::filesystem::path folder;          ///< missing or empty, unless a map is added to it
    std::vector<RobotDescription> robots;  ///< robots of its station
    std::string version;                   ///< version of the program, for the session that is written
};

/// Returns the error that @p folder, into which a map should be carried, is not empty.
[[nodiscard]] Error isThere(const std::filesystem::path& folder);

/// Checks that carryMap() would find a map in the mission folder @p mission; the error says why not. Reads
/// only a little of it.
[[nodiscard]] Result<void> hasMap(const std::filesystem::path& mission);

/// Writes the map of the mission @p from to the new mission @p into, as a separate session. Carries the
/// certain scans with their poses and links, and the map's area. Afterwards the new mission does not need
/// @p from, which is not changed. Robots of the carried scans are called NAME@FOLDER there. Robots of the new
/// mission are placed only by what they see: they map new parts until a place is found that both maps have
/// seen. Finds, trails and what was searched are not carried. Returns the number of certain scans. Errors
/// name the mission: @p from has no map by Leitstand, or the new folder is not empty. An incomplete new
/// mission is removed.
[[nodiscard]] Result<std::size_t> carryMap(const std::filesystem::path& from, const CarriedInto& into,
                                           const Progress& progress = {});

/// Adds the map of @p from to the mission @p into as a separate part, beside the map there. The relative pose
/// of the two is unknown. Only the area of the map that was there is kept. Returns the number of added
/// certain scans. Error when @p from has no map, the mission cannot be written, or when cancelled. The
/// mission may then have some of the scans.
[[nodiscard]] Result<std::size_t> addMap(const std::filesystem::path& from, const CarriedInto& into,
                                         const Progress& progress = {});

}  // namespace leitstand
