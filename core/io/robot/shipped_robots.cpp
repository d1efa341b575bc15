#include "core/io/robot/shipped_robots.h"

#include <set>

#include "core/base/words.h"
#include "core/io/settings/folders.h"
#include "core/io/yaml/yaml_errors.h"

namespace leitstand {
namespace fs = std::filesystem;
namespace {

bool looksLikeAPath(const std::string& text) {
    return text.empty() || text.find('/') != std::string::npos || text.ends_with(".yaml") ||
           text.ends_with(".yml");
}

}  // namespace

std::vector<fs::path> robotFolders() {
    std::vector<fs::path> folders;
    for (const fs::path& folder : {userFolder("robots"), shippedFolder("robots")}) {
        if (!folder.empty()) folders.push_back(folder);
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
    return Error{
        names.empty()
            ? leitstand::fill(translate("leitstand::Error", "{}: expected a robot's file, found none"),
                              nameOrPath)
            : leitstand::fill(
                  translate("leitstand::Error", "{}: expected a robot's file, or the name {}, found none{}"),
                  nameOrPath, detail::anyOf(names), detail::likely(nameOrPath, names))};
}

}  // namespace leitstand
