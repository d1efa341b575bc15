#include <memory>
#include <string>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/cli/console/output.h"
#include "app/cli/console/progress_line.h"
#include "app/cli/options/load_scans.h"
#include "app/services/interrupt.h"
#include "app/services/recorded/merged_map.h"
#include "app/services/review/map_tidying.h"
#include "core/version/version.h"

namespace leitstand::cli {
namespace {

struct MergeArguments {
    MergeOrder order;
    bool tidy = true, json = false;
};

void printResult(const MergeOrder& order, const MergedMap& merged, bool json) {
    if (json) {
        printJson({{"first", merged.first},
                   {"second", merged.second},
                   {"sought", merged.sought},
                   {"found", merged.found},
                   {"agreeing", merged.agreeing},
                   {"together", merged.together},
                   {"aside", merged.aside}});
        return;
    }
    print(
        "{} and {} key scans; of {} places of the later mission {} were found in the earlier one, {} of them "
        "agree\n",
        merged.first, merged.second, merged.sought, merged.found, merged.agreeing);
    if (merged.together) {
        print("one map now: {}\n", order.into.string());
        if (merged.aside > 0)
            print("but for {} key scans of the later mission, which had mapped them apart\n", merged.aside);
        return;
    }
    print(
        "how they lie to each other is not sure: {} has both, side by side;\n"
        "a station that goes on with it (leitstand --live --mission {}) joins them by hand\n",
        order.into.string(), order.into.string());
}

int run(const MergeArguments& arguments) {
    ProgressLine line;
    const InterruptGuard interrupt;
    const auto show = [&](double fraction) { line.show("merging", fraction); };
    const auto merged = mergeMaps(arguments.order, {show, interrupt.token()});
    if (!merged) {
        complain(line, merged.error().text);
        return 1;
    }
    std::string untidied;
    if (merged->together && arguments.tidy) {
        TidySettings settings;
        settings.mapping = arguments.order.mapping;
        settings.version = arguments.order.version;
        const auto showTidying = [&](double fraction) { line.show("tidying", fraction); };
        const auto tidied = tidyMap(arguments.order.into, settings, {showTidying, interrupt.token()});
        if (!tidied) untidied = tidied.error().text;
    }
    line.clear();
    printResult(arguments.order, *merged, arguments.json);
    if (!untidied.empty())
        complain(line, "the maps are one, but not relaxed (leitstandctl tidy does that): " + untidied);
    return merged->together && untidied.empty() ? 0 : 1;
}

}  // namespace

void addMerge(CLI::App& app, int& exitCode) {
    CLI::App* command =
        app.add_subcommand("merge", "brings the maps of two missions into one, in a new mission");
    const auto arguments = std::make_shared<MergeArguments>();
    arguments->order.version = versionOf("leitstandctl");
    command->add_option("MISSION", arguments->order.first, "Folder of a mission")->required();
    command->add_option("OTHER", arguments->order.second, "Folder of another one")->required();
    command->add_option("-o,--output", arguments->order.into, "Folder of the new mission")
        ->required()
        ->type_name("FOLDER");
    command->add_flag("!--no-tidy", arguments->tidy, "Do not relax the scans that overlap then");
    command->add_flag("--json", arguments->json, "Print JSON");
    command->footer(
        "Both missions stay as they are; the map of the one that began first stays where it is. Exit code 1 "
        "on errors, and where no places are found for sure that both have seen: the new mission has the two "
        "side by side then.");
    command->final_callback([arguments, &exitCode] { exitCode = run(*arguments); });
}

}  // namespace leitstand::cli
