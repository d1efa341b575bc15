#include <chrono>
#include <cstdio>
#include <memory>
#include <optional>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/cli/commands.h"
#include "app/cli/console/output.h"
#include "app/cli/console/progress_line.h"
#include "app/cli/options/load_scans.h"
#include "app/cli/options/register_options.h"
#include "app/cli/register_report.h"
#include "app/services/interrupt.h"
#include "core/io/clouds/cloud_writer.h"
#include "core/io/clouds/tum.h"
#include "core/mapping/mapper.h"

namespace leitstand::cli {
namespace {

using Clock = std::chrono::steady_clock;

/// Keeps the guess poses of the scans that could be read; an error when there are not as many poses as files.
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
            // Scans without a time are numbered in seconds: TUM lines must have rising stamps.
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

int runRegister(const RegisterOptions& options) {
    ProgressLine line;
    const InterruptGuard interrupt;
    auto settings = resolvedSettings(options);
    if (!settings) {
        complain(line, settings.error().text);
        return 1;
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
    Mapper mapper(chosen);
    for (std::size_t i = 0; i < scans.size(); ++i) {
        const auto show = [&](double fraction) {
            line.show("registering " + scans[i].scan->name, (double(i) + fraction) / double(scans.size()));
        };
        if (!mapper.add(scans[i].scan, {show, interrupt.token()})) break;
    }
    const MapPtr map = mapper.map();
    const double seconds = std::chrono::duration<double>(Clock::now() - started).count();
    line.clear();
    print(options.json ? registerJson(*map, seconds) : registerTable(*map, seconds));
    const bool written = writeOutputs(options, *map, line);
    if (interrupt.token().stop_requested()) {
        complain(line, fmt::format("interrupted: {} of {} scans are registered", map->scans.size(),
                                   loaded->expected));
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
