#include "core/io/robot/shipped_robots.h"

#include <cstdlib>
#include <set>

#include <fmt/format.h>

#include "core/io/robot/yaml_errors.h"

namespace leitstand {
namespace fs = std::filesystem;
namespace {

bool looksLikeAPath(const std::string& text) {
    return text.empty() || text.find('/') != std::string::npos || text.ends_with(".yaml") ||
           text.ends_with(".yml");
}

/// What @p variable of the environment says; empty when it is not there.
std::string environment(const char* variable) {
    const char* value = std::getenv(variable);
    return value == nullptr ? std::string() : value;
}

}  // namespace

std::vector<fs::path> robotFolders() {
    std::vector<fs::path> folders;
    if (const fs::path config = environment("XDG_CONFIG_HOME"); !config.empty()) {
        folders.push_back(config / "leitstand/robots");
    } else if (const fs::path home = environment("HOME"); !home.empty()) {
        folders.push_back(home / ".config/leitstand/robots");
    }
    std::error_code problem;
    if (const fs::path resources = environment("LEITSTAND_RESOURCES"); !resources.empty()) {
        folders.push_back(resources / "robots");
    } else if (const fs::path program = fs::read_symlink("/proc/self/exe", problem); !problem) {
        folders.push_back(program.parent_path().parent_path() / "share/leitstand/robots");
    }
    return folders;
}

std::vector<std::string> shippedRobots(const std::vector<fs::path>& folders) {
    std::set<std::string> names;
    for (const fs::path& folder : folders) {
        std::error_code problem;
        for (fs::directory_iterator entry(folder, problem), end; !problem && entry != end;
             entry.increment(problem)) {
            if (entry->path().extension() == ".yaml") names.insert(entry->path().stem().string());
        }
    }
    return {names.begin(), names.end()};
}

Result<fs::path> findRobotFile(const std::string& nameOrPath, const std::vector<fs::path>& folders) {
    std::error_code problem;
    if (looksLikeAPath(nameOrPath) || fs::exists(nameOrPath, problem)) return fs::path(nameOrPath);
    for (const fs::path& folder : folders) {
        const fs::path file = folder / (nameOrPath + ".yaml");
        if (fs::exists(file, problem)) return file;
    }
    const auto names = shippedRobots(folders);
    return Error{fmt::format("{}: expected a robot's file{}, found none{}", nameOrPath,
                             names.empty() ? "" : ", or the name " + detail::anyOf(names),
                             detail::likely(nameOrPath, names))};
}

}  // namespace leitstand
