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
#include "app/services/review/map_tidying.h"
#include "core/version/version.h"

namespace leitstand::cli {
namespace {

struct TidyArguments {
    std::string mission;
    TidySettings settings;
    bool undo = false, json = false;
};

void printResult(const TidiedMap& tidied, bool json) {
    const Relaxation& relaxed = tidied.relaxation;
    if (json) {
        printJson({{"scans", tidied.scans},
                   {"matched", relaxed.matched},
                   {"moved", tidied.moved},
                   {"contradicted", relaxed.contradicted.size()},
                   {"rounds", relaxed.rounds},
                   {"settled", relaxed.settled},
                   {"largest_shift", relaxed.largest},
                   {"rms_before", relaxed.rmsBefore},
                   {"rms_after", relaxed.rmsAfter}});
        return;
    }
    print(
        "{} of {} scans fit what lies about them; pairs {:.1f} mm apart before, {:.1f} mm after {} "
        "rounds{}\n",
        relaxed.matched, tidied.scans, 1e3 * relaxed.rmsBefore, 1e3 * relaxed.rmsAfter, relaxed.rounds,
        relaxed.settled ? "" : ", not settled");
    if (!relaxed.contradicted.empty())
        print("{} links of loops contradict the rest and do not count any more\n",
              relaxed.contradicted.size());
    if (tidied.moved == 0 && tidied.linked > 0) {
        print("nothing moved noticeably; the scans, which had no links, have {} now\n", tidied.linked);
    } else if (tidied.moved == 0) {
        print("nothing moved noticeably, nothing was written\n");
    } else {
        print("{} scans moved, by up to {:.3f} m; --undo takes it back\n", tidied.moved, relaxed.largest);
    }
}

int run(const TidyArguments& arguments) {
    ProgressLine line;
    const InterruptGuard interrupt;
    if (arguments.undo) {
        const auto undone = untidyMap(arguments.mission, arguments.settings.version);
        if (undone) return 0;
        complain(line, undone.error().text);
        return 1;
    }
    const auto show = [&](double fraction) { line.show("tidying", fraction); };
    const auto tidied = tidyMap(arguments.mission, arguments.settings, {show, interrupt.token()});
    line.clear();
    if (!tidied) {
        complain(line, tidied.error().text);
        return 1;
    }
    printResult(*tidied, arguments.json);
    return 0;
}

}  // namespace

void addTidy(CLI::App& app, int& exitCode) {
    CLI::App* command = app.add_subcommand(
        "tidy", "relaxes the map of a mission: all scans that overlap, whenever they were taken");
    const auto arguments = std::make_shared<TidyArguments>();
    arguments->settings.version = versionOf("leitstandctl");
    command->add_option("MISSION", arguments->mission, "Folder of the mission")->required();
    command
        ->add_option("--rounds", arguments->settings.relaxation.rounds,
                     "At most so many rounds of matching all scans")
        ->check(CLI::Range(1, 100))
        ->type_name("N")
        ->capture_default_str();
    command->add_option("--threads", arguments->settings.relaxation.threads, "0: one a core")
        ->check(CLI::Range(0, 1024))
        ->type_name("N")
        ->capture_default_str();
    command->add_flag("--undo", arguments->undo, "Take back the newest tidying instead");
    command->add_flag("--json", arguments->json, "Print JSON");
    command->footer("What was recorded stays as it is: what moved is written as a session of its own.");
    command->final_callback([arguments, &exitCode] { exitCode = run(*arguments); });
}

}  // namespace leitstand::cli
