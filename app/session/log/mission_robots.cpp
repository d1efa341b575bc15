#include "app/session/log/mission_robots.h"

#include <algorithm>
#include <fstream>

#include <fmt/format.h>

#include "core/io/robot/robot_file.h"

namespace leitstand {
namespace fs = std::filesystem;

Result<void> keepRobots(const fs::path& folder, const std::vector<RobotDescription>& robots) {
    if (robots.empty()) return {};
    std::error_code problem;
    fs::create_directories(folder / "robots", problem);
    for (const RobotDescription& robot : robots) {
        const fs::path file = folder / "robots" / (robot.name + ".yaml");
        std::ofstream out(file, std::ios::trunc);
        out << writeRobot(robot);
        out.close();
        if (!out) return Error{file.string() + ": cannot be written"};
    }
    return {};
}

std::vector<RobotDescription> keptRobots(const fs::path& folder, std::vector<std::string>& warnings) {
    std::vector<fs::path> files;
    std::error_code problem;
    for (const auto& entry : fs::directory_iterator(folder / "robots", problem)) {
        if (entry.path().extension() == ".yaml") files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    std::vector<RobotDescription> robots;
    for (const fs::path& file : files) {
        auto robot = readRobot(file);
        if (robot) {
            robots.push_back(std::move(robot).value());
        } else {
            warnings.push_back(robot.error().text);
        }
    }
    return robots;
}

}  // namespace leitstand
