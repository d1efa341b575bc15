#include "robots/simulation/app/choose_arena.h"

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
    return readArena(gradeOrFile);
}

}  // namespace leitstand::simulation
