#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
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
#include "app/services/domain/domain_probe.h"
#include "app/services/interrupt.h"
#include "core/base/printable.h"
#include "core/event/stream_role.h"
#include "core/io/detail/output_file.h"
#include "core/io/robot/robot_file.h"
#include "transport/domain/join_settings.h"

namespace leitstand::cli {
namespace {

namespace fs = std::filesystem;

struct ProbeOptions {
    DomainOptions domain;
    double seconds = 5.0;
    std::string out = ".";
    bool json = false;
};

std::string qosText(const SeenTopic& topic) {
    const bool reliable = topic.qos.reliability == Qos::Reliability::Reliable;
    const bool stays = topic.qos.durability == Qos::Durability::TransientLocal;
    return std::string(reliable ? "reliable" : "best effort") + (stays ? ", transient local" : "");
}

/// What a topic is used for, and by which robot.
struct Use {
    std::string robot, role, remark;
};

std::map<std::string, Use> usesOf(const ProbeReport& report) {
    std::map<std::string, Use> uses;
    for (const RobotGuess& guess : report.robots) {
        for (const TopicVerdict& verdict : guess.topics) {
            Use& use = uses[verdict.topic.name];
            use.robot += (use.robot.empty() ? "" : " ") + guess.robot.name;
            if (verdict.role) use.role = toString(*verdict.role);
            use.remark = verdict.remark;
        }
    }
    return uses;
}

std::string probeTable(const ProbeReport& report) {
    if (report.topics.empty()) {
        return "Nobody is there. Same ROS_DOMAIN_ID (--domain)? Same network, multicast let through (else "
               "--peer)? Robots on this computer that speak to nobody else (ROS_LOCALHOST_ONLY=1): "
               "--interface lo. "
               "A robot on another middleware (rmw) than DDS cannot be heard.\n";
    }
    const auto uses = usesOf(report);
    std::vector<std::vector<std::string>> rows = {
        {"topic", "type", "robot", "used as", "rate", "kB/s", "lost", "QoS", "hosts", ""}};
    for (const ProbedTopic& probed : report.topics) {
        const auto found = uses.find(probed.topic.name);
        const Use use = found == uses.end() ? Use{} : found->second;
        rows.push_back({probed.topic.name, probed.topic.type, use.robot, use.role.empty() ? "–" : use.role,
                        probed.writers > 0 ? fmt::format("{:.1f} Hz", probed.rate) : "",
                        probed.writers > 0 ? fmt::format("{:.1f}", probed.bytesPerSecond / 1e3) : "",
                        probed.writers > 0 ? fmt::format("{}", probed.lost) : "", qosText(probed.topic),
                        probed.hosts, use.remark});
    }
    return textTable(rows);
}

std::string probeJson(const ProbeReport& report, const std::map<std::string, std::string>& files,
                      const std::vector<std::string>& environment) {
    using Json = nlohmann::ordered_json;
    const auto uses = usesOf(report);
    Json topics = Json::array(), robots = Json::array();
    for (const ProbedTopic& probed : report.topics) {
        const auto found = uses.find(probed.topic.name);
        const Use use = found == uses.end() ? Use{} : found->second;
        topics.push_back({{"topic", probed.topic.name},
                          {"type", probed.topic.type},
                          {"robot", use.robot},
                          {"role", use.role},
                          {"remark", use.remark},
                          {"writers", probed.writers},
                          {"readers", probed.readers},
                          {"rate", probed.rate},
                          {"bytes_per_second", probed.bytesPerSecond},
                          {"lost", probed.lost},
                          {"qos", qosText(probed.topic)},
                          {"hosts", probed.hosts}});
    }
    for (const RobotGuess& guess : report.robots) {
        const auto file = files.find(guess.robot.name);
        robots.push_back({{"name", guess.robot.name}, {"file", file == files.end() ? "" : file->second}});
    }
    return jsonText({{"seconds", report.seconds},
                     {"robots", robots},
                     {"topics", topics},
                     {"environment", environment},
                     {"warnings", report.warnings}});
}

/// Writes a first file for each robot into @p folder and never overwrites one. Returns the files by robot.
/// Sets @p ok to false when one cannot be written.
std::map<std::string, std::string> writeRobotFiles(const ProbeReport& report, const fs::path& folder,
                                                   ProgressLine& line, bool& ok) {
    std::map<std::string, std::string> files;
    for (const RobotGuess& guess : report.robots) {
        if (guess.robot.streams.empty()) continue;
        const fs::path file = folder / (guess.robot.name + ".yaml");
        std::error_code problem;
        if (fs::exists(file, problem)) {
            complain(line, file.string() + " is there already and stays as it is");
            continue;
        }
        if (const auto written = detail::writeWhole(file, writeRobot(guess.robot)); !written) {
            complain(line, written.error().text);
            ok = false;
            continue;
        }
        files.emplace(guess.robot.name, file.string());
    }
    return files;
}

int runProbe(const ProbeOptions& options) {
    ProgressLine line;
    const InterruptGuard interrupt(InterruptGuard::End::Surely);
    const auto domain = withEnvironment(options.domain);
    if (!domain) {
        complain(line, domain.error().text);
        return 1;
    }
    const auto probe = DomainProbe::open(*domain);
    if (!probe) {
        complain(line, probe.error().text);
        return 1;
    }
    const auto show = [&line](double fraction) { line.show("listening", fraction); };
    const ProbeReport report = (*probe)->listen(options.seconds, {.report = show, .stop = interrupt.token()});
    line.clear();
    bool ok = true;
    const auto files = writeRobotFiles(report, options.out, line, ok);
    print(options.json ? probeJson(report, files, domain->fromEnvironment) : probeTable(report));
    if (!options.json) {
        if (const std::string by = environmentLine(*domain); !by.empty()) print("{}\n", printable(by));
        print("{}\n", securityLine(*domain));
        for (const auto& [robot, file] : files) {
            print("wrote {}: check letter, sizes, limits and sensor poses (docs/robots.md)\n",
                  printable(file));
        }
    }
    std::fflush(stdout);  // before threads of the library can hang
    for (const std::string& warning : report.warnings) complain(line, warning);
    return ok ? 0 : 1;
}

}  // namespace

void addProbe(CLI::App& app, int& exitCode) {
    CLI::App* command = app.add_subcommand(
        "probe",
        "listens to a domain: robots, topics, what fits and what will not work; writes first robot files");
    const auto options = std::make_shared<ProbeOptions>();
    addDomainOptions(*command, options->domain);
    command->add_option("--seconds", options->seconds, "How long to listen [s] (5)")
        ->check(CLI::Range(0.5, 3600.0));
    command->add_option("--out", options->out, "Folder for the robot files (the present one)")
        ->check(CLI::ExistingDirectory)
        ->type_name("DIR");
    command->add_flag("--json", options->json, "Print JSON");
    command->final_callback([options, &exitCode] { exitCode = runProbe(*options); });
}

}  // namespace leitstand::cli
