#include "robots/simulation/arena/arena_file.h"

#include <fstream>

namespace leitstand::simulation {

Result<Arena> readArena(const std::filesystem::path& file) {
    constexpr std::streamsize Most = std::streamsize{1} << 20U;  // more is no arena: parsing fails
    std::ifstream in(file, std::ios::binary);
    if (!in) return Error{file.string() + ": cannot be opened; expected an arena file (YAML)"};
    std::string text(static_cast<std::size_t>(Most), '\0');
    in.read(text.data(), Most);
    if (in.bad()) return Error{file.string() + ": cannot be read"};
    text.resize(static_cast<std::size_t>(in.gcount()));
    return parseArena(text, file.string());
}

}  // namespace leitstand::simulation
