#include <memory>
#include <string>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/cli/console/output.h"
#include "app/cli/console/progress_line.h"
#include "app/cli/options/load_scans.h"
#include "app/services/interrupt.h"
#include "app/services/thinning/mission_thinning.h"

namespace leitstand::cli {
namespace {

struct ThinArguments {
    std::string mission, out;
    ThinningSettings settings;
    bool json = false;
};

int runThin(const ThinArguments& arguments) {
    ProgressLine line;
    const InterruptGuard interrupt;
    const auto show = [&](double fraction) { line.show("thinning", fraction); };
    const auto outcome =
        thinMission(arguments.mission, arguments.out, arguments.settings, {show, interrupt.token()});
    line.clear();
    if (!outcome) {
        complain(line, outcome.error().text);
        return 1;
    }
    if (arguments.json) {
        printJson({{"kept", outcome->kept}, {"left", outcome->left}, {"problems", outcome->problems}});
    } else {
        print("{} events kept, {} left out\n", outcome->kept, outcome->left);
    }
    for (const std::string& problem : outcome->problems) complain(line, problem);
    return 0;
}

}  // namespace

void addThin(CLI::App& app, int& exitCode) {
    CLI::App* command = app.add_subcommand(
        "thin", "writes a small copy of a mission: map, finds and their evidence, and little of the rest");
    const auto arguments = std::make_shared<ThinArguments>();
    command
        ->add_option("MISSION", arguments->mission,
                     "Folder of the mission, or one file of it (.db3, .mcap, .bag)")
        ->required();
    command->add_option("--out", arguments->out, "Folder of the copy; must not exist")->required();
    const auto rate = [&](const char* name, double& value, const std::string& what) {
        command->add_option(name, value, what)
            ->check(CLI::Range(0.0, 1000.0))
            ->type_name("HZ")
            ->capture_default_str();
    };
    rate("--pictures", arguments->settings.pictures, "Pictures a second of each camera");
    rate("--clouds", arguments->settings.clouds,
         "Slices of 3D scanners a second (the map stays without them)");
    rate("--ranges", arguments->settings.ranges, "Turns a second of plane lasers");
    rate("--motion", arguments->settings.motion, "Odometry and transforms a second");
    rate("--others", arguments->settings.others, "Of what else comes steadily, a second");
    command->add_option("--seconds", arguments->settings.seconds, "Only so much of its beginning (all of it)")
        ->check(CLI::Range(0.0, 1e6))
        ->type_name("S");
    command->add_flag("--json", arguments->json, "Print JSON");
    command->final_callback([arguments, &exitCode] { exitCode = runThin(*arguments); });
}

}  // namespace leitstand::cli
