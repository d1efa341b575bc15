#include "robots/simulation/process/choose_arena.h"

#include <filesystem>
#include <system_error>

#include "robots/simulation/arena/arena_file.h"
#include "robots/simulation/arena/arena_generator.h"

namespace leitstand::simulation {

std::optional<Grade> gradeFrom(const std::string& name) {
    for (const Grade grade : {Grade::Yellow, Grade::Orange, Grade::Red}) {
        if (name == toString(grade)) return grade;
    }
    return std::nullopt;
}

Result<Arena> chooseArena(const std::string& gradeOrFile, std::uint64_t seed) {
    if (const auto grade = gradeFrom(gradeOrFile)) return generateArena(*grade, seed);
    std::error_code problem;
    if (!std::filesystem::exists(gradeOrFile, problem))
        return Error{gradeOrFile + ": cannot be opened; expected yellow, orange, red or an arena file"};
    return readArena(gradeOrFile);
}

}  // namespace leitstand::simulation
