#include <atomic>
#include <csignal>
#include <cstdio>
#include <memory>
#include <string>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/cli/console/output.h"
#include "app/cli/console/progress_line.h"
#include "app/cli/options/load_scans.h"
#include "app/options/domain_options.h"
#include "app/services/interrupt.h"
#include "app/services/log/replay/mission_replay.h"
#include "core/base/printable.h"

namespace leitstand::cli {
namespace {

struct ReplayOptions {
    ReplaySettings settings;
    DomainOptions domain;
    std::string mission;
    bool json = false;
};

/// Toggled by SIGUSR1. Lock-free, so that a signal handler may access it.
std::atomic<bool> paused = false;

void onPauseSignal(int) {
    paused = !paused;
}

std::string outcomeJson(const ReplayOutcome& outcome) {
    return jsonText({{"published", outcome.published},
                     {"held_back", outcome.heldBack},
                     {"held_back_topics", outcome.heldBackTopics},
                     {"problems", outcome.problems}});
}

int runReplay(ReplayOptions& options) {
    ProgressLine line;
    const InterruptGuard interrupt(InterruptGuard::End::Surely);
    options.settings.mission = options.mission;
    auto domain = withEnvironment(options.domain);
    if (!domain) {
        complain(line, domain.error().text);
        return 1;
    }
    options.settings.domain = std::move(domain).value();
    if (const std::string by = environmentLine(options.settings.domain); !by.empty()) complain(line, by);
    const auto replay = MissionReplay::open(options.settings, {.report = {}, .stop = interrupt.token()});
    if (!replay) {
        complain(line, replay.error().text);
        return 1;
    }
    static_assert(std::atomic<bool>::is_always_lock_free);
    std::signal(SIGUSR1, onPauseSignal);
    const auto show = [&line](double fraction) { line.show(paused ? "paused" : "replaying", fraction); };
    const ReplayOutcome outcome = (*replay)->play(paused, {.report = show, .stop = interrupt.token()});
    std::signal(SIGUSR1, SIG_DFL);
    line.clear();
    if (options.json) {
        print(outcomeJson(outcome));
    } else {
        print("{} samples published, {} held back", outcome.published, outcome.heldBack);
        for (std::size_t i = 0; i < outcome.heldBackTopics.size(); ++i) {
            print("{}{}", i == 0 ? " (commands, stops and the station's own: " : " ",
                  printable(outcome.heldBackTopics[i]));
        }
        print("{}\n", outcome.heldBackTopics.empty() ? "" : ")");
    }
    std::fflush(stdout);  // before threads of the library can hang
    for (const std::string& problem : outcome.problems) complain(line, problem);
    if (interrupt.token().stop_requested() && !options.settings.loop) {
        complain(line, "interrupted");
        return 1;
    }
    return 0;
}

}  // namespace

void addReplay(CLI::App& app, int& exitCode) {
    CLI::App* command = app.add_subcommand("replay",
                                           "publishes what a mission's robots said; never commands, stops or "
                                           "grants. SIGUSR1 pauses and goes on");
    const auto options = std::make_shared<ReplayOptions>();
    command
        ->add_option("MISSION", options->mission,
                     "Folder of the mission, or one file of it (.db3, .mcap, .bag)")
        ->required();
    addDomainOptions(*command, options->domain);
    command->add_option("--rate", options->settings.rate, "How many times faster than it came (1)")
        ->check(CLI::Range(0.01, 1000.0));
    command->add_flag("--loop", options->settings.loop, "Begin again at the end, until Ctrl-C");
    command->add_flag("--json", options->json, "Print the summary as JSON");
    command->final_callback([options, &exitCode] { exitCode = runReplay(*options); });
}

}  // namespace leitstand::cli
