#include "app/session/station/choose_robots.h"

#include <utility>

#include "core/io/robot/robot_file.h"
#include "core/io/robot/shipped_robots.h"

namespace leitstand {

Result<std::vector<RobotDescription>> chooseRobots(const std::vector<std::string>& files) {
    std::vector<RobotDescription> robots;
    for (const std::string& name : files) {
        const auto file = findRobotFile(name);
        if (!file) return file.error();
        auto robot = readRobot(*file);
        if (!robot) return robot.error();
        robots.push_back(std::move(robot).value());
    }
    return robots;
}

}  // namespace leitstand
