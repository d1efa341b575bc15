#include <memory>
#include <string>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/cli/console/output.h"
#include "app/cli/console/progress_line.h"
#include "app/cli/options/load_scans.h"
#include "app/services/handin/report_source.h"
#include "app/services/interrupt.h"
#include "core/mapping/comparison/map_changes.h"

namespace leitstand::cli {
namespace {

struct ChangesArguments {
    std::string mission;
    bool json = false;
};

std::string nameOf(const std::string& mission) {
    return mission.empty() ? "this mission" : mission;
}

std::string earlierOf(const Visits& visits) {
    std::string text;
    for (const std::string& name : visits.earlier)
        text += fmt::format("{}{}", text.empty() ? "" : ", ", nameOf(name));
    return text;
}

nlohmann::json jsonOf(const Eigen::Vector3d& vector) {
    return {vector.x(), vector.y(), vector.z()};
}

void printResult(const MapChanges& changes, bool json) {
    if (json) {
        nlohmann::json things = nlohmann::json::array();
        for (const ChangedThing& thing : changes.things) {
            things.push_back({{"what", thing.isNew ? "new" : "gone"},
                              {"middle", jsonOf(thing.box.center())},
                              {"size", jsonOf(thing.box.sizes())},
                              {"scan", thing.scan}});
        }
        printJson({{"earlier", changes.visits.earlier},
                   {"later", changes.visits.name},
                   {"scans_before", changes.visits.before.size()},
                   {"scans_after", changes.visits.after.size()},
                   {"things", things}});
        return;
    }
    print("{} -> {}: {} and {} key scans\n", earlierOf(changes.visits), nameOf(changes.visits.name),
          changes.visits.before.size(), changes.visits.after.size());
    for (const ChangedThing& thing : changes.things) {
        const Eigen::Vector3d size = thing.box.sizes(), middle = thing.box.center();
        print("{:<5} {:.1f} x {:.1f} x {:.1f} m at x {:.2f}, y {:.2f}, z {:.2f}\n",
              thing.isNew ? "new" : "gone", size.x(), size.y(), size.z(), middle.x(), middle.y(), middle.z());
    }
    if (changes.things.empty()) print("nothing changed where both looked\n");
}

int run(const ChangesArguments& arguments) {
    constexpr double Reading = 0.3;  // share of the work
    ProgressLine line;
    const InterruptGuard interrupt;
    const auto reading = [&](double share) { line.show("reading", Reading * share); };
    const auto source = ReportSource::open(arguments.mission, {reading, interrupt.token()});
    if (!source) {
        complain(line, source.error().text);
        return 1;
    }
    const auto comparing = [&](double share) { line.show("comparing", Reading + (1.0 - Reading) * share); };
    const MapChanges changes = changesOf(source->input().scans, {}, {comparing, interrupt.token()});
    line.clear();
    if (interrupt.token().stop_requested()) {
        complain(line, "cancelled");
        return 1;
    }
    if (changes.compared == 0) {
        const bool several = !changes.visits.after.empty();
        complain(line, arguments.mission +
                           (several ? ": the maps of its missions have not met: nothing can be compared"
                                    : ": expected a map of several missions, as merge or --map-of make it"));
        return 1;
    }
    printResult(changes, arguments.json);
    return 0;
}

}  // namespace

void addChanges(CLI::App& app, int& exitCode) {
    CLI::App* command = app.add_subcommand(
        "changes", "tells what came and what went between the missions that a map is put together from");
    const auto arguments = std::make_shared<ChangesArguments>();
    command->add_option("MISSION", arguments->mission, "Folder of the mission")->required();
    command->add_flag("--json", arguments->json, "Print JSON");
    command->footer(
        "The newest of its missions is compared with those before. Listed is what scans of the one have "
        "where "
        "scans of the other looked through.");
    command->final_callback([arguments, &exitCode] { exitCode = run(*arguments); });
}

}  // namespace leitstand::cli
