#include "core/io/robot/shipped_robots.h"

#include <algorithm>
#include <cstdlib>

#include <fmt/format.h>

namespace leitstand {
namespace {

namespace fs = std::filesystem;

fs::path robotFolder() {
    if (const char* resources = std::getenv("LEITSTAND_RESOURCES")) return fs::path(resources) / "robots";
    std::error_code problem;
    const fs::path program = fs::read_symlink("/proc/self/exe", problem);
    return program.parent_path().parent_path() / "share/leitstand/robots";
}

}  // namespace

std::vector<std::string> shippedRobots() {
    std::vector<std::string> names;
    std::error_code problem;
    for (const auto& entry : fs::directory_iterator(robotFolder(), problem)) {
        if (entry.path().extension() == ".yaml") names.push_back(entry.path().stem().string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

Result<fs::path> findRobotFile(const std::string& nameOrPath) {
    std::error_code problem;
    if (fs::exists(nameOrPath, problem)) return fs::path(nameOrPath);
    const auto names = shippedRobots();
    if (std::find(names.begin(), names.end(), nameOrPath) != names.end())
        return robotFolder() / (nameOrPath + ".yaml");
    return Error{fmt::format("{}: cannot be opened; expected a robot file, or one of {}", nameOrPath,
                             fmt::join(names, ", "))};
}

}  // namespace leitstand
