#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/base/result.h"
#include "robots/simulation/arena/building_generator.h"

namespace leitstand::simulation {

[[nodiscard]] std::optional<Grade> gradeFrom(const std::string& name);
/// What is asked of a building, as on the command line.
struct BuildingOptions {
    std::string size;  ///< "60x40"; empty: as usual
    std::optional<int> storeys;
    bool twins = false, smooth = false;

    [[nodiscard]] bool any() const { return !size.empty() || storeys || twins || smooth; }
};

/// The arena that @p gradeOrFile means; @p seed is of generated ones, @p building of "building" alone.
[[nodiscard]] Result<Arena> chooseArena(const std::string& gradeOrFile, std::uint64_t seed,
                                        const BuildingOptions& building = {});

}  // namespace leitstand::simulation
