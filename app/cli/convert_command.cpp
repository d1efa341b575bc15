#include <memory>
#include <string>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/cli/console/output.h"
#include "app/cli/console/progress_line.h"
#include "app/cli/options/load_scans.h"
#include "app/services/interrupt.h"
#include "core/io/bag/bag_conversion.h"

namespace leitstand::cli {
namespace {

struct ConvertArguments {
    std::string bag, out, storage = "mcap";
    bool json = false;
};

int runConvert(const ConvertArguments& arguments) {
    ProgressLine line;
    const InterruptGuard interrupt;
    const auto show = [&](double fraction) { line.show("converting", fraction); };
    const auto outcome = convertBag(arguments.bag, arguments.out,
                                    arguments.storage == "mcap" ? BagStorage::Mcap : BagStorage::Sqlite,
                                    {show, interrupt.token()});
    line.clear();
    if (!outcome) {
        complain(line, outcome.error().text);
        return 1;
    }
    if (arguments.json) {
        printJson({{"messages", outcome->messages}, {"problems", outcome->problems}});
    } else {
        print("{} messages written\n", outcome->messages);
    }
    for (const std::string& problem : outcome->problems) complain(line, problem);
    return 0;
}

}  // namespace

void addConvert(CLI::App& app, int& exitCode) {
    CLI::App* command = app.add_subcommand(
        "convert", "copies a bag or mission into MCAP or SQLite files, with all its messages");
    const auto arguments = std::make_shared<ConvertArguments>();
    command->add_option("BAG", arguments->bag, "Folder of the bag, or one file of it (.db3, .mcap, .bag)")
        ->required();
    command->add_option("--out", arguments->out, "Folder of the copy; must not exist")->required();
    command->add_option("--storage", arguments->storage, "Of the copy: mcap (compressed by zstd) or sqlite3")
        ->check(CLI::IsMember({"mcap", "sqlite3"}))
        ->capture_default_str();
    command->add_flag("--json", arguments->json, "Print JSON");
    command->final_callback([arguments, &exitCode] { exitCode = runConvert(*arguments); });
}

}  // namespace leitstand::cli
