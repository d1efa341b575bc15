#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/base/result.h"
#include "robots/simulation/arena/arena.h"

namespace leitstand::simulation {

[[nodiscard]] std::optional<Grade> gradeFrom(const std::string& name);
/// The arena that @p gradeOrFile means; @p seed is of generated ones.
[[nodiscard]] Result<Arena> chooseArena(const std::string& gradeOrFile, std::uint64_t seed);

}  // namespace leitstand::simulation
