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

}  // namespace

void addRobots(CLI::App& app, int& exitCode) {
    for (const std::string kind : {"kurt3d", "crawler"}) {
        auto options = std::make_shared<RobotOptions>();
        options->kind = kind;
        CLI::App* command = app.add_subcommand(kind, "Drives a simulated " + kind + " in real time");
        command->add_option("--arena", options->arena,
                            "yellow, orange, red, building, or an arena file (yellow)");
        command->add_option("--seed", options->seed, "Of the arena and of all noise (1)");
        addBuilding(*command, options->building);
        command->add_option("--robot", options->file,
                            "Its file (YAML), or the name of a shipped one (" + kind + ")");
        command->add_option("--name", options->name, "Of the robot and its topics (" + kind + ")");
        command->add_option("--domain", options->domain, "DDS domain (0); the truth is on the one 100 above")
            ->check(CLI::Range(0, 132));
        command->add_option("--interface", options->interfaces, "Network interfaces to use (all)");
        command->add_option("--peer", options->peers, "Addresses of stations where multicast does not pass");
        command->add_option("--keys", options->keys, "Identity in a secured domain, KEYS/enclaves/NAME");
        command->add_flag("--no-watchdog", options->careless,
                          "Goes on without commands, and obeys whoever sends one, as many stock robots do");
        if (kind == "kurt3d")
            command->add_flag("--tilting", options->tilting, "Carries the tilting scanner of 2004");
        else
            command->add_flag("--turning-laser", options->turningLaser, "Its laser turns: 3D slices");
        command->callback([options, &exitCode] { exitCode = reported(runRobot(*options)); });
    }
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
