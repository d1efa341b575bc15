#include <chrono>
#include <ctime>
#include <memory>
#include <string>
#include <vector>

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/cli/console/output.h"
#include "app/cli/console/progress_line.h"
#include "app/cli/console/text_table.h"
#include "app/cli/options/load_scans.h"
#include "app/services/log/mission_robots.h"
#include "core/base/printable.h"
#include "core/base/time.h"
#include "core/io/bag/bag_reader.h"

namespace leitstand::cli {
namespace {

struct InfoOptions {
    std::string mission;
    bool json = false;
};

std::string dateOf(Time time) {
    const std::time_t seconds = std::chrono::system_clock::to_time_t(
        std::chrono::time_point_cast<std::chrono::system_clock::duration>(time));
    return fmt::format("{:%Y-%m-%d %H:%M:%S}", fmt::localtime(seconds));
}

/// Counts the messages of all sessions. Pictures dropped for a slow disk have a sequence, but no message.
std::uint64_t eventsOf(const BagReader& bag) {
    std::uint64_t events = 0;
    for (const BagSession& session : bag.sessions()) {
        const auto range = session.lastSequence == 0 ? 0 : session.lastSequence - session.firstSequence + 1;
        events += session.messages.value_or(range);
    }
    return events;
}

std::string infoJson(const BagReader& bag, const std::vector<RobotDescription>& robots,
                     const std::vector<std::string>& problems) {
    using Json = nlohmann::ordered_json;
    Json sessions = Json::array(), topics = Json::array(), names = Json::array();
    for (const BagSession& session : bag.sessions()) {
        sessions.push_back({{"file", session.file.filename().string()},
                            {"first_sequence", session.firstSequence},
                            {"last_sequence", session.lastSequence},
                            {"first_ns", session.first.time_since_epoch().count()},
                            {"last_ns", session.last.time_since_epoch().count()},
                            {"closed", session.closed},
                            {"damaged", session.damaged},
                            {"missing", session.missing}});
    }
    for (const BagTopic& topic : bag.topics()) {
        topics.push_back({{"topic", topic.info.name},
                          {"type", topic.info.type},
                          {"messages", topic.messages.value_or(0)},
                          {"definition", !topic.info.definition.empty()}});
    }
    for (const RobotDescription& robot : robots) names.push_back(robot.name);
    return jsonText({{"events", eventsOf(bag)},
                     {"seconds", secondsBetween(bag.first(), bag.last())},
                     {"ours", bag.ours()},
                     {"robots", names},
                     {"sessions", sessions},
                     {"topics", topics},
                     {"problems", problems}});
}

std::string infoText(const BagReader& bag, const std::vector<RobotDescription>& robots) {
    const double seconds = secondsBetween(bag.first(), bag.last());
    std::string text = bag.lastSequence() == 0
                           ? std::string("no events\n")
                           : fmt::format("{} to {}, {:.1f} s, {} events\n", dateOf(bag.first()),
                                         dateOf(bag.last()), seconds, eventsOf(bag));
    for (const RobotDescription& robot : robots)
        text += fmt::format("robot {} {}\n", robot.letter, printable(robot.name));
    for (const BagSession& session : bag.sessions()) {
        text += fmt::format(
            "session {}{}{}{}\n", printable(session.file.filename().string()),
            session.closed ? "" : ", still written or cut off", session.damaged ? ", damaged" : "",
            session.missing > 0 ? fmt::format(", {} events are missing", session.missing) : "");
    }
    std::vector<std::vector<std::string>> rows = {{"topic", "type", "messages", "rate"}};
    for (const BagTopic& topic : bag.topics()) {
        const auto messages = topic.messages.value_or(0);
        rows.push_back({topic.info.name, topic.info.type, fmt::format("{}", messages),
                        seconds > 0.0 ? fmt::format("{:.1f} Hz", double(messages) / seconds) : ""});
    }
    return text + textTable(rows);
}

int runInfo(const InfoOptions& options) {
    ProgressLine line;
    const auto bag = BagReader::open(options.mission);
    if (!bag) {
        complain(line, bag.error().text);
        return 1;
    }
    (*bag)->count();
    std::vector<std::string> problems;
    const auto robots = keptRobots(options.mission, problems);
    problems.insert(problems.end(), (*bag)->problems().begin(), (*bag)->problems().end());
    print(options.json ? infoJson(**bag, robots, problems) : infoText(**bag, robots));
    for (const std::string& problem : problems) complain(line, problem);
    return 0;
}

}  // namespace

void addInfo(CLI::App& app, int& exitCode) {
    CLI::App* command = app.add_subcommand("info", "tells what a mission (a rosbag2 SQLite bag) holds");
    const auto options = std::make_shared<InfoOptions>();
    command
        ->add_option("MISSION", options->mission,
                     "Folder of the mission, or one file of it (.db3, .mcap, .bag)")
        ->required();
    command->add_flag("--json", options->json, "Print JSON");
    command->final_callback([options, &exitCode] { exitCode = runInfo(*options); });
}

}  // namespace leitstand::cli
