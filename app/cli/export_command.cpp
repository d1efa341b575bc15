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
#include "app/services/handin/writing/mission_export.h"
#include "app/services/interrupt.h"
#include "core/base/printable.h"

namespace leitstand::cli {
namespace {

struct ExportArguments {
    std::string mission, out, height = "low";
    ExportOptions options;
    bool json = false;
};

nlohmann::ordered_json jsonOf(const ExportOutcome& outcome) {
    using Json = nlohmann::ordered_json;
    Json files = Json::array();
    for (const ReportFile& file : outcome.files)
        files.push_back({{"file", file.name}, {"bytes", file.bytes}, {"check", file.check}});
    return {{"files", files}, {"warnings", outcome.warnings}};
}

int runExport(const ExportArguments& arguments) {
    ProgressLine line;
    const InterruptGuard interrupt;
    const auto show = [&](double fraction) { line.show("export", fraction); };
    const auto outcome =
        exportMission(arguments.mission, arguments.out, arguments.options, {show, interrupt.token()});
    line.clear();
    if (!outcome) {
        complain(line, outcome.error().text);
        return 1;
    }
    if (arguments.json) {
        printJson(jsonOf(*outcome));
    } else {
        for (const ReportFile& file : outcome->files)
            print("{}: {}\n", printable(file.name), printable(file.check));
    }
    for (const std::string& warning : outcome->warnings) complain(line, warning);
    return 0;
}

/// Returns the endings by subject: ".pcd .ply points, .bt OctoMap".
std::string formatList() {
    std::string list, subject;
    for (const ExportFormat& format : exportFormats()) {
        if (!subject.empty()) list += format.subject == subject ? " " : " " + subject + ", ";
        list += format.ending;
        subject = format.subject;
    }
    return list + " " + subject;
}

}  // namespace

void addExport(CLI::App& app, int& exitCode) {
    CLI::App* command =
        app.add_subcommand("export", "writes the map or part of a mission for other programs");
    const auto arguments = std::make_shared<ExportArguments>();
    command
        ->add_option("MISSION", arguments->mission,
                     "Folder of the mission, or one file of it (.db3, .mcap, .bag)")
        ->required();
    command
        ->add_option(
            "--out", arguments->out,
            "By its ending: " + formatList() +
                " (NAME_victims.csv and NAME_qr.csv those, others all points of interest), DIR/ uos scans "
                "with poses. Of several robots NAME.tum becomes NAME_ROBOT.tum for each; what is written is "
                "printed")
        ->required();
    command
        ->add_option("--reduce", arguments->options.reduce,
                     "Points: one for each cube of this edge [m]; 0: all")
        ->check(CLI::Range(0.0, 10.0));
    command->add_option("--robot", arguments->options.robot,
                        "Trajectory of this robot only, in the file that --out names");
    command
        ->add_option("--height", arguments->height,
                     "Of GeoTIFF and grid map: low (0.25 to 0.35 m) or upper (0.9 to 1.1 m)")
        ->check(CLI::IsMember({"low", "upper"}));
    command->add_option(
        "--storey", arguments->options.storey,
        "Of GeoTIFF and grid map: only this storey, 0 where the map begins, 1 above it, -1 below; "
        "else all in one, as seen from above");
    command->add_flag("--json", arguments->json, "Print JSON");
    command->final_callback([arguments, &exitCode] {
        if (!canExport(arguments->out)) {
            throw CLI::ValidationError("--out", expectedOfExport());
        }
        if (arguments->options.storey && !showsStoreys(arguments->out))
            throw CLI::ValidationError("--storey",
                                       "expected a map seen from above, NAME.tif or NAME.pgm, as --out");
        arguments->options.upper = arguments->height == "upper";
        exitCode = runExport(*arguments);
    });
}

}  // namespace leitstand::cli
