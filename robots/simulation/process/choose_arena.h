#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/base/result.h"
#include "robots/simulation/arena/building_generator.h"

namespace leitstand::simulation {

[[nodiscard]] std::optional<Grade> gradeFrom(const std::string& name);
/// Options for a generated building on the command line.
struct BuildingOptions {
    std::string size;  ///< "60x40"; empty: default size
    std::optional<int> storeys;
    bool twins = false, smooth = false;

    [[nodiscard]] bool any() const { return !size.empty() || storeys || twins || smooth; }
};

/// Returns the arena of a grade or from a file. @p seed is used for generated arenas, @p building only for
/// the grade "building". Error when @p building is set for another arena, or the file cannot be read.
[[nodiscard]] Result<Arena> chooseArena(const std::string& gradeOrFile, std::uint64_t seed,
                                        const BuildingOptions& building = {});

}  // namespace leitstand::simulation
