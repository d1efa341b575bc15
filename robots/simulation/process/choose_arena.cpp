#include "robots/simulation/process/choose_arena.h"

#include <filesystem>
#include <system_error>
#include <utility>

#include "robots/simulation/arena/arena_file.h"
#include "robots/simulation/arena/arena_generator.h"

namespace leitstand::simulation {

namespace {

Result<Arena> building(const BuildingOptions& options, std::uint64_t seed) {
    BuildingSettings settings;
    if (!options.size.empty()) {
        const auto size = buildingSizeFrom(options.size);
        if (!size) return size.error();
        settings.width = size->x();
        settings.depth = size->y();
    }
    settings.storeys = options.storeys.value_or(settings.storeys);
    settings.twins = options.twins;
    settings.smooth = options.smooth;
    auto made = generateBuilding(settings, seed);
    if (!made) return made.error();
    return std::move(made->arena);
}

}  // namespace

std::optional<Grade> gradeFrom(const std::string& name) {
    for (int i = 0; i < GradeCount; ++i) {
        if (name == toString(static_cast<Grade>(i))) return static_cast<Grade>(i);
    }
    return std::nullopt;
}

Result<Arena> chooseArena(const std::string& gradeOrFile, std::uint64_t seed,
                          const BuildingOptions& options) {
    const auto grade = gradeFrom(gradeOrFile);
    if (grade == Grade::Building) return building(options, seed);
    if (options.any())
        return Error{gradeOrFile +
                     ": expected no --size, --storeys, --twins or --smooth: these are of building"};
    if (grade) return generateArena(*grade, seed);
    std::error_code problem;
    if (!std::filesystem::exists(gradeOrFile, problem))
        return Error{gradeOrFile +
                     ": cannot be opened; expected yellow, orange, red, building or an arena file"};
    return readArena(gradeOrFile);
}

}  // namespace leitstand::simulation
