#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/cli/commands.h"
#include "app/cli/console/output.h"
#include "app/cli/console/progress_line.h"
#include "app/cli/options/load_scans.h"
#include "app/cli/options/register_options.h"
#include "app/cli/register_report.h"
#include "app/services/interrupt.h"
#include "core/base/time.h"
#include "core/io/clouds/cloud_writer.h"
#include "core/io/clouds/tum.h"
#include "core/io/graph/given_links.h"
#include "core/mapping/offline_mapper.h"
#include "core/mapping/relaxation/closed_map.h"

namespace leitstand::cli {
namespace {

using Clock = std::chrono::steady_clock;

/// Keeps the guess poses of the scans that could be read. Error when there are not as many poses as @p files.
Result<void> matchGuesses(RegistrationSettings& settings, const std::vector<LoadedScan>& scans,
                          std::size_t files) {
    if (settings.guess != GuessSource::Poses) return {};
    if (settings.guessPoses.size() != files) {
        return Error{fmt::format("--guess: expected {} poses, one a scan, found {}", files,
                                 settings.guessPoses.size())};
    }
    std::vector<Pose> kept;
    for (const LoadedScan& scan : scans) kept.push_back(settings.guessPoses[scan.position]);
    settings.guessPoses = kept;
    return {};
}

/// Converts the links of @p given from positions among @p files to indices of @p scans. The error names a
/// scan that does not exist or could not be read.
Result<std::vector<GivenLink>> placed(std::vector<GivenLink> given, const std::vector<LoadedScan>& scans,
                                      std::size_t files) {
    const auto find = [&](std::size_t& place) -> Result<void> {
        if (place >= files)
            return Error{
                fmt::format("--by-hand: scan {}: expected one of the {} scans, from 0", place, files)};
        const auto found = std::find_if(scans.begin(), scans.end(),
                                        [&](const LoadedScan& scan) { return scan.position == place; });
        if (found == scans.end()) return Error{fmt::format("--by-hand: scan {} could not be read", place)};
        place = static_cast<std::size_t>(found - scans.begin());
        return {};
    };
    for (GivenLink& one : given) {
        if (auto known = find(one.from); !known) return known.error();
        if (auto known = find(one.to); !known) return known.error();
    }
    return given;
}

bool writeOutputs(const RegisterOptions& options, const Map& map, ProgressLine& line) {
    bool ok = true;
    const auto report = [&](const Result<void>& written) {
        if (written) return;
        complain(line, written.error().text);
        ok = false;
    };
    if (!options.posesFile.empty()) {
        std::vector<TimedPose> poses;
        for (std::size_t i = 0; i < map.scans.size(); ++i) {
            const Time stamp = map.scans[i].scan->end;
            // A scan without a time gets its number in seconds: stamps of TUM lines must rise.
            poses.push_back(
                {stamp == Time{} ? Time(std::chrono::seconds(i)) : stamp, map.scans[i].poseInMap});
        }
        report(writeTum(options.posesFile, poses));
    }
    if (!options.mapFile.empty()) {
        std::vector<PlacedScan> placed;
        for (const MapScan& scan : map.scans) placed.push_back({scan.scan, scan.poseInMap});
        report(writeMapCloud(options.mapFile, placed, {options.range[0], options.range[1]}));
    }
    return ok;
}

/// Closes the loops of @p map and moves its scans, for --close-loops. Error when links of @p byHand cannot be
/// used.
Result<ClosedMap> closed(Map& map, const std::vector<GivenLink>& byHand, const RegistrationSettings& chosen,
                         const Progress& progress) {
    LiveSettings settings;
    settings.match.minRange = chosen.minRange;
    settings.match.maxRange = std::min(settings.match.maxRange, chosen.maxRange);
    RelaxationSettings how;
    how.threads = chosen.threads;
    auto loops = closeLoops(map, byHand, settings, how, progress);
    if (!loops) return Error{"--by-hand: " + loops.error().text};
    for (std::size_t i = 0; i < loops->poses.size(); ++i) map.scans[i].poseInMap = loops->poses[i];
    return loops;
}

int runRegister(const RegisterOptions& options) {
    ProgressLine line;
    const InterruptGuard interrupt;
    auto settings = resolvedSettings(options);
    if (!settings) {
        complain(line, settings.error().text);
        return 1;
    }
    std::vector<GivenLink> byHand;
    if (!options.byHand.empty()) {
        auto read = readGivenLinks(options.byHand);
        if (!read) {
            complain(line, read.error().text);
            return 1;
        }
        byHand = std::move(read).value();
    }
    const auto started = Clock::now();
    const auto loaded = loadScans(options.sources, interrupt.token(), line);
    if (!loaded) {
        complain(line, loaded.error().text);
        return 1;
    }
    const std::vector<LoadedScan>& scans = loaded->scans;
    RegistrationSettings chosen = *settings;
    if (const auto matched = matchGuesses(chosen, scans, loaded->expected); !matched) {
        complain(line, matched.error().text);
        return 1;
    }
    const auto links = placed(std::move(byHand), scans, loaded->expected);
    if (!links) {
        complain(line, links.error().text);
        return 1;
    }
    OfflineMapper mapper(chosen);
    for (std::size_t i = 0; i < scans.size(); ++i) {
        const auto show = [&](double fraction) {
            line.show("registering " + scans[i].scan->name, (double(i) + fraction) / double(scans.size()));
        };
        if (!mapper.add(scans[i].scan, {show, interrupt.token()})) break;
    }
    Map map = *mapper.map();
    std::optional<ClosedMap> loops;
    if (options.closeLoops && !interrupt.token().stop_requested()) {
        const auto show = [&](double fraction) { line.show("closing loops", fraction); };
        auto done = closed(map, *links, chosen, {show, interrupt.token()});
        if (!done) {
            complain(line, done.error().text);
            return 1;
        }
        if (!interrupt.token().stop_requested()) loops = std::move(done).value();
    }
    const ClosedMap* const closedLoops = loops ? &*loops : nullptr;
    const double seconds = toSeconds(Clock::now() - started);
    line.clear();
    print(options.json ? registerJson(map, closedLoops, seconds) : registerTable(map, closedLoops, seconds));
    const bool written = writeOutputs(options, map, line);
    if (interrupt.token().stop_requested()) {
        const bool all = map.scans.size() == scans.size();
        complain(line, all && options.closeLoops ? std::string("interrupted: loops are not closed")
                                                 : fmt::format("interrupted: {} of {} scans are registered",
                                                               map.scans.size(), loaded->expected));
        return 1;
    }
    return written && loaded->broken == 0 ? 0 : 1;
}

}  // namespace

void addRegister(CLI::App& app, int& exitCode) {
    CLI::App* command = app.add_subcommand("register", "registers 3D scans into one map");
    const auto options = std::make_shared<RegisterOptions>();
    declareRegisterOptions(*command, *options);
    command->final_callback([options, &exitCode] {
        if (options->range[0] >= options->range[1]) {
            throw CLI::ValidationError("--range", "the nearest range must be below the farthest");
        }
        exitCode = runRegister(*options);
    });
}

}  // namespace leitstand::cli
