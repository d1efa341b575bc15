#include "app/services/station/choose_robots.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "core/base/words.h"
#include "core/event/stream_role.h"
#include "core/io/detail/output_file.h"
#include "core/io/robot/robot_file.h"
#include "core/io/robot/shipped_robots.h"
#include "core/robot/team.h"
#include "transport/convert/readings/field_numbers.h"

namespace leitstand {
Result<void> checkReadings(const RobotDescription& robot) {
    for (const StreamDescription& stream : robot.streams) {
        if (stream.role != StreamRole::Reading) continue;
        const auto fail = [&](const std::string& text) {
            return Error{fmt::format("{}: streams: {}: {}", robot.file, stream.topic, text)};
        };
        const MessageText* const text = knownText(stream.type);
        if (text == nullptr)
            return fail(
                leitstand::fill(translate("leitstand::Error",
                                          "messages of type {} are not known, so nothing in them is read"),
                                stream.type));
        std::vector<std::string> paths;
        for (const ReadingDescription& reading : stream.readings) paths.push_back(reading.field);
        if (const auto found = checkPaths(*text, paths); !found) return fail(found.error().text);
    }
    return {};
}

Result<std::vector<RobotDescription>> chooseRobots(const std::vector<std::string>& files) {
    std::vector<RobotDescription> robots;
    for (const std::string& name : files) {
        const auto file = findRobotFile(name);
        if (!file) return file.error();
        auto robot = readRobot(*file);
        if (!robot) return robot.error();
        if (const auto readable = checkReadings(*robot); !readable) return readable.error();
        robots.push_back(std::move(robot).value());
    }
    return robots;
}

void useFile(std::vector<std::string>& files, const std::vector<RobotDescription>& robots,
             const std::string& robot, const std::string& file) {
    for (std::size_t i = 0; i < robots.size() && i < files.size(); ++i) {
        if (robots[i].name != robot) continue;
        std::error_code problem;
        const auto meant = findRobotFile(files[i]);
        if (!meant || !std::filesystem::equivalent(*meant, file, problem)) files[i] = file;
    }
}

Result<void> checkJoins(const std::string& file, std::vector<RobotDescription> team) {
    auto robots = chooseRobots({file});
    if (!robots) return robots.error();
    team.push_back(robots->front());
    return checkTeam(team);
}

Result<std::string> writeFirstFile(RobotDescription robot, const std::vector<RobotDescription>& team) {
    const std::filesystem::path file = robotFolders().front() / (robot.name + ".yaml");
    std::error_code problem;
    if (std::filesystem::exists(file, problem)) return file.string();
    const auto isTaken = [&](const std::string& letter) {
        return std::any_of(team.begin(), team.end(),
                           [&](const RobotDescription& one) { return one.letter == letter; });
    };
    // Diagnostics that all share are another's, where nothing tells whose a status is.
    std::erase_if(robot.streams, [&](const StreamDescription& stream) {
        const auto shares = [&](const RobotDescription& one) {
            return std::any_of(one.streams.begin(), one.streams.end(),
                               [&](const StreamDescription& other) { return other.topic == stream.topic; });
        };
        return stream.role == StreamRole::Diagnostics && stream.hardwareId.empty() &&
               std::any_of(team.begin(), team.end(), shares);
    });
    for (char letter = 'A'; letter <= 'Z' && isTaken(robot.letter); ++letter) robot.letter = letter;
    std::filesystem::create_directories(file.parent_path(), problem);
    if (const auto written = detail::writeWhole(file, writeRobot(robot)); !written) return written.error();
    return file.string();
}

}  // namespace leitstand
