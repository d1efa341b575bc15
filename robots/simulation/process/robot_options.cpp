#include "robots/simulation/process/robot_options.h"

#include <cstdio>
#include <filesystem>
#include <memory>

#include <CLI/CLI.hpp>

#include "core/base/printable.h"
#include "core/io/detail/output_file.h"
#include "robots/simulation/arena/arena_file.h"
#include "robots/simulation/process/choose_arena.h"
#include "robots/simulation/process/robot_process.h"
#include "robots/simulation/stock/stock_profile.h"

namespace leitstand::simulation {
namespace {

int reported(const Result<void>& outcome) {
    if (outcome) return 0;
    std::fprintf(stderr, "%s\n", printable(outcome.error().text).c_str());
    return 1;
}

Result<void> writeTo(const std::string& file, const RobotOptions& options) {
    if (!gradeFrom(options.arena)) return Error{options.arena + ": expected yellow, orange, red or building"};
    const auto arena = chooseArena(options.arena, options.seed, options.building);
    if (!arena) return arena.error();
    return detail::writeWhole(file, writeArena(*arena));
}

void addBuilding(CLI::App& command, BuildingOptions& building) {
    command.add_option("--size", building.size, "Of a building, WIDTHxDEPTH in metres (60x40)");
    command.add_option("--storeys", building.storeys, "Of a building, joined by ramps and stairs (1)");
    command.add_flag("--twins", building.twins, "A building whose rooms and corridors are all alike");
    command.add_flag("--smooth", building.smooth,
                     "A building of bare corridors: no rooms, doors or furniture");
}

void addWorld(CLI::App& command, RobotOptions& options) {
    command.add_option("--arena", options.arena, "yellow, orange, red, building, or an arena file (yellow)");
    command.add_option("--seed", options.seed, "Of the arena and of all noise (1)");
    addBuilding(command, options.building);
}

void addNetwork(CLI::App& command, DomainOptions& network) {
    command
        .add_option("--domain", network.domain,
                    "DDS domain (as ROS_DOMAIN_ID, else 0); the truth is on the one 100 above")
        ->check(CLI::Range(0, LastDomain));
    command.add_option("--interface", network.interfaces, "Network interfaces to use (all)");
    command.add_option("--peer", network.initialPeers,
                       "Addresses of stations where multicast does not pass (as ROS_STATIC_PEERS)");
    command.add_option("--discovery-server", network.discoveryServer,
                       "Discovery servers, ADDRESS:PORT;ADDRESS:PORT (as ROS_DISCOVERY_SERVER)");
    command.add_option("--keys", network.keys, "Identity in a secured domain, KEYS/enclaves/NAME");
}

}  // namespace

void addRobots(CLI::App& app, int& exitCode) {
    for (const std::string kind : {"kurt3d", "crawler"}) {
        auto options = std::make_shared<RobotOptions>();
        options->kind = kind;
        CLI::App* command = app.add_subcommand(kind, "Drives a simulated " + kind + " in real time");
        addWorld(*command, *options);
        command->add_option("--robot", options->file,
                            "Its file (YAML), or the name of a shipped one (" + kind + ")");
        command->add_option("--name", options->name, "Of the robot and its topics (" + kind + ")");
        addNetwork(*command, options->network);
        command->add_flag("--no-watchdog", options->careless,
                          "Goes on without commands, and obeys whoever sends one, as many stock robots do");
        if (kind == "kurt3d")
            command->add_flag("--tilting", options->tilting, "Carries the tilting scanner of 2004");
        else
            command->add_flag("--turning-laser", options->turningLaser, "Its laser turns: 3D slices");
        command->callback([options, &exitCode] { exitCode = reported(runRobot(*options)); });
    }
}

void addStock(CLI::App& app, int& exitCode) {
    auto options = std::make_shared<RobotOptions>();
    auto profile = std::make_shared<std::string>();
    CLI::App* command = app.add_subcommand(
        "stock", "Drives a simulated robot that publishes and takes only what its maker ships");
    command->add_option("PROFILE", *profile, "turtlebot4, husky, ouster, livox or tracked")
        ->required()
        ->check(CLI::IsMember(stockProfiles()).description(""));
    auto* nameSpace = command->add_option("--namespace", options->nameSpace,
                                          "Of its topics (husky: a200_0000; others: none)");
    addWorld(*command, *options);
    addNetwork(*command, options->network);
    command->callback([options, profile, nameSpace, &exitCode] {
        options->stock = stockProfile(*profile);
        options->kind = options->stock->body;
        if (nameSpace->count() == 0) options->nameSpace = options->stock->nameSpace;
        while (options->nameSpace.starts_with('/')) options->nameSpace.erase(0, 1);
        exitCode = reported(runRobot(*options));
    });
}

void addArena(CLI::App& app, int& exitCode) {
    auto options = std::make_shared<RobotOptions>();
    auto file = std::make_shared<std::string>();
    CLI::App* command = app.add_subcommand("arena", "Writes a generated arena into a file");
    command->add_option("GRADE", options->arena, "yellow, orange, red or building")->required();
    command->add_option("--seed", options->seed, "Another seed rearranges everything (1)");
    addBuilding(*command, options->building);
    command->add_option("--out", *file, "Arena file (YAML)")->required();
    command->callback([options, file, &exitCode] { exitCode = reported(writeTo(*file, *options)); });
}

}  // namespace leitstand::simulation
