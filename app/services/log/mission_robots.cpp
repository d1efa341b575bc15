#include "app/services/log/mission_robots.h"

#include <algorithm>
#include <fstream>
#include <iterator>

#include <fmt/format.h>

#include "app/services/domain/robot_guess.h"
#include "core/io/bag/bag_reader.h"
#include "core/io/detail/output_file.h"
#include "core/io/robot/robot_file.h"

namespace leitstand {
namespace fs = std::filesystem;

namespace {

std::string contentOf(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// Keeps the file of an earlier session beside the newer one: robots/earlier/kurt3d-1.yaml.
Result<void> keepEarlier(const fs::path& file, const std::string& content) {
    const fs::path folder = file.parent_path() / "earlier";
    std::error_code problem;
    fs::create_directories(folder, problem);
    for (int number = 1;; ++number) {
        const fs::path kept = folder / fmt::format("{}-{}.yaml", file.stem().string(), number);
        if (!fs::exists(kept, problem)) return detail::writeWhole(kept, content);
    }
}

}  // namespace

Result<void> keepRobots(const fs::path& folder, const std::vector<RobotDescription>& robots) {
    if (robots.empty()) return {};
    std::error_code problem;
    fs::create_directories(folder / "robots", problem);
    for (const RobotDescription& robot : robots) {
        const fs::path file = folder / "robots" / (robot.name + ".yaml");
        const std::string text = writeRobot(robot);
        if (const std::string earlier = contentOf(file); !earlier.empty()) {
            if (earlier == text) continue;
            if (const auto kept = keepEarlier(file, earlier); !kept) return kept.error();
        }
        if (const auto written = detail::writeWhole(file, text); !written) return written.error();
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

std::vector<RobotDescription> robotsOf(const fs::path& mission, const BagReader& bag,
                                       std::vector<std::string>& warnings) {
    auto robots = keptRobots(fs::is_directory(mission) ? mission : mission.parent_path(), warnings);
    if (!robots.empty()) return robots;
    std::vector<SeenTopic> seen;
    for (const BagTopic& topic : bag.topics()) {
        SeenTopic one;
        one.name = topic.info.name;
        one.type = topic.info.type;
        seen.push_back(std::move(one));
    }
    for (RobotGuess& guess : guessRobots(seen)) robots.push_back(std::move(guess.robot));
    return robots;
}

void carryMapping(const fs::path& folder, std::vector<RobotDescription>& robots) {
    const auto maps = [](const StreamDescription& stream) { return stream.maps; };
    for (RobotDescription& robot : robots) {
        const auto before = readRobot(folder / "robots" / (robot.name + ".yaml"));
        if (!before) continue;
        const auto mapping = std::find_if(before->streams.begin(), before->streams.end(), maps);
        const bool there = mapping != before->streams.end() &&
                           std::any_of(robot.streams.begin(), robot.streams.end(), [&](const auto& stream) {
                               return robot.mayMap(stream) && stream.topic == mapping->topic;
                           });
        if (!there) continue;
        for (StreamDescription& stream : robot.streams)
            stream.maps = robot.mayMap(stream) && stream.topic == mapping->topic;
    }
}

}  // namespace leitstand
