#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/cli/console/output.h"
#include "app/cli/console/progress_line.h"
#include "app/cli/console/text_table.h"
#include "app/cli/options/load_scans.h"
#include "app/options/domain_options.h"
#include "app/services/interrupt.h"
#include "app/services/log/mission_recorder.h"
#include "app/services/station/choose_robots.h"
#include "core/io/bag/bag_storage.h"
#include "core/io/robot/robot_file.h"
#include "core/io/robot/shipped_robots.h"
#include "core/robot/team.h"
#include "core/version/version.h"
#include "transport/domain/join_settings.h"

namespace leitstand::cli {
namespace {

struct RecordOptions {
    std::string out;
    DomainOptions domain;
    std::vector<std::string> robots;
    std::string storage;
    bool json = false;
};

std::string recordJson(const RecorderStatus& status) {
    nlohmann::ordered_json topics = nlohmann::ordered_json::array();
    for (const auto& topic : status.topics) {
        topics.push_back(
            {{"topic", topic.name},
             {"type", topic.type},
             {"samples", topic.samples},
             {"lost", topic.lost},
             {"dropped", status.log.dropped.contains(topic.name) ? status.log.dropped.at(topic.name) : 0}});
    }
    nlohmann::ordered_json robots = nlohmann::ordered_json::array();
    for (const LinkStatus& link : status.links) {
        robots.push_back({{"robot", link.robot},
                          {"link", toString(link.state)},
                          {"reasons", toString(link.reasons)},
                          {"reconnects", link.reconnects},
                          {"megabits_per_second", link.megabitsPerSecond}});
    }
    nlohmann::ordered_json screened = nlohmann::ordered_json::array();
    for (const ScreenDrop& drop : status.screened)
        screened.push_back({{"what", toString(drop)}, {"from", drop.from}, {"packets", drop.packets}});
    return jsonText({{"events", status.log.events},
                     {"bytes", status.log.bytes},
                     {"lost", status.log.lost},
                     {"robots", robots},
                     {"unheard", status.notReceived},
                     {"topics", topics},
                     {"screened", screened}});
}

std::string recordTable(const RecorderStatus& status) {
    std::vector<std::vector<std::string>> rows = {{"topic", "type", "samples", "lost", "dropped"}};
    for (const auto& topic : status.topics) {
        const auto dropped = status.log.dropped.find(topic.name);
        rows.push_back({topic.name, topic.type, fmt::format("{}", topic.samples),
                        fmt::format("{}", topic.lost),
                        dropped == status.log.dropped.end() ? "0" : fmt::format("{}", dropped->second)});
    }
    return textTable(rows) +
           fmt::format("{} events, {:.1f} MB\n", status.log.events, double(status.log.bytes) / 1e6);
}

void showStatus(ProgressLine& line, const RecorderStatus& status) {
    const double minutes = status.log.minutesLeft;
    if (!status.log.problem.empty()) {
        line.show("NOTHING CAN BE WRITTEN: " + status.log.problem);
        return;
    }
    const std::string left = minutes < 6000.0 ? fmt::format(", disk lasts {:.0f} min", minutes) : "";
    std::string robots;
    for (const LinkStatus& link : status.links) {
        robots +=
            fmt::format("{} {} {:.2f} Mbit/s, ", link.robot, toString(link.state), link.megabitsPerSecond);
    }
    line.show(fmt::format("{}{} topics, {} events, {:.1f} MB, {:.2f} MB/s{}", robots, status.topics.size(),
                          status.log.events, double(status.log.bytes) / 1e6, status.log.bytesPerSecond / 1e6,
                          left));
}

int runRecord(const RecordOptions& options) {
    ProgressLine line;
    const InterruptGuard interrupt(InterruptGuard::End::Surely);
    RecorderSettings settings;
    settings.mission.folder = options.out;
    if (!options.storage.empty())
        settings.mission.storage =
            options.storage == nameOf(BagStorage::Mcap) ? BagStorage::Mcap : BagStorage::Sqlite;
    settings.mission.title = "leitstandctl record";
    settings.mission.version = version();
    auto domain = withEnvironment(options.domain);
    if (!domain) {
        complain(line, domain.error().text);
        return 1;
    }
    settings.domain = std::move(domain).value();
    for (const std::string& file : options.robots) {
        const auto found = findRobotFile(file);
        if (!found) {
            complain(line, found.error().text);
            return 1;
        }
        auto robot = readRobot(*found);
        if (!robot) {
            complain(line, robot.error().text);
            return 1;
        }
        if (const auto readable = checkReadings(*robot); !readable) {
            complain(line, readable.error().text);
            return 1;
        }
        settings.mission.robots.push_back(std::move(robot).value());
    }
    if (const auto team = checkTeam(settings.mission.robots); !team) {
        complain(line, team.error().text);
        return 1;
    }
    std::mutex printing;
    const auto recorder = MissionRecorder::start(settings, [&](const std::string& text) {
        const std::lock_guard lock(printing);
        complain(line, text);
    });
    if (!recorder) {
        complain(line, recorder.error().text);
        return 1;
    }
    complain(line,
             fmt::format("recording domain {} into {}; Ctrl-C ends it", settings.domain.domain, options.out));
    if (const std::string by = environmentLine(settings.domain); !by.empty()) complain(line, by);
    complain(line, securityLine(settings.domain));
    std::mutex mutex;
    std::condition_variable_any ended;
    std::unique_lock lock(mutex);
    const std::stop_token stop = interrupt.token();
    while (
        !ended.wait_for(lock, stop, std::chrono::milliseconds(500), [&] { return stop.stop_requested(); })) {
        // Before `printing` is locked: a thread that reports may hold a lock that status() takes.
        const RecorderStatus now = (*recorder)->status();
        const std::lock_guard quiet(printing);
        showStatus(line, now);
    }
    RecorderStatus status = (*recorder)->status();
    const auto stopped = (*recorder)->stop();
    status.log = (*recorder)->status().log;
    line.clear();
    print(options.json ? recordJson(status) : recordTable(status));
    std::fflush(stdout);  // before threads of the library can hang
    for (const auto& [topic, errors] : status.log.broken) {
        complain(line, fmt::format("{}: {} samples make no sense (kept all the same), the last one: {}",
                                   topic, errors.count, errors.last));
    }
    if (!status.notReceived.empty()) {
        complain(line,
                 fmt::format("announced, but nothing came of it: {}", fmt::join(status.notReceived, ", ")));
    }
    for (const ScreenDrop& drop : status.screened) complain(line, toString(drop));
    if (!stopped) complain(line, stopped.error().text);
    if (status.log.lost > 0) {
        complain(line, fmt::format("{} events other than pictures are lost: the disk did not keep up",
                                   status.log.lost));
    }
    return stopped && status.log.lost == 0 ? 0 : 1;
}

}  // namespace

void addRecord(CLI::App& app, int& exitCode) {
    CLI::App* command = app.add_subcommand("record", "records what robots say into a mission, until Ctrl-C");
    const auto options = std::make_shared<RecordOptions>();
    command->add_option("--out", options->out, "Folder of the mission; one that exists is gone on with")
        ->required()
        ->type_name("MISSION");
    addDomainOptions(*command, options->domain);
    command
        ->add_option("--robot", options->robots,
                     "Robot files (or names of shipped ones: kurt3d, crawler, turtlebot, turtlebot4, husky, "
                     "ouster, livox, tracked) "
                     "whose listed "
                     "topics to record; without any, every topic that is heard")
        ->type_name("YAML...");
    command
        ->add_option(
            "--storage", options->storage,
            "Of the files: sqlite3 or mcap (compressed by zstd); by default as the mission's earlier "
            "ones, and the first in sqlite3")
        ->check(CLI::IsMember({"mcap", "sqlite3"}));
    command->add_flag("--json", options->json, "Print the summary as JSON");
    command->final_callback([options, &exitCode] { exitCode = runRecord(*options); });
}

}  // namespace leitstand::cli
