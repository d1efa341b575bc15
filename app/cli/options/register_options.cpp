#include "app/cli/options/register_options.h"

#include <cmath>
#include <map>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "core/io/clouds/cloud_formats.h"
#include "core/io/clouds/tum.h"

namespace leitstand::cli {
namespace {

/// Accepts a finite number in [@p low, @p high]. CLI::Range alone also accepts "nan".
CLI::Validator number(double low, double high, const std::string& what) {
    return {[=](std::string& text) -> std::string {
                double value = 0.0;
                if (!CLI::detail::lexical_cast(text, value) || !(value >= low && value <= high)) {
                    return "expected " + what + ", found \"" + text + "\"";
                }
                return {};
            },
            ""};
}

template <class Enum>
void addChoice(CLI::App& command, const std::string& name, Enum& value,
               const std::map<std::string, Enum>& names, const std::string& help) {
    std::string list, current;
    for (const auto& [text, choice] : names) {
        list += (list.empty() ? "" : "|") + text;
        if (choice == value) current = text;
    }
    command.add_option(name, value, help)
        ->transform(CLI::CheckedTransformer(names).description(""))
        ->option_text(list + " (" + current + ")");
}

}  // namespace

void declareRegisterOptions(CLI::App& command, RegisterOptions& options) {
    RegistrationSettings& settings = options.settings;
    command
        .add_option("SOURCE", options.sources,
                    fmt::format("a folder of uos scans, cloud files ({}) in order, or a mission",
                                listOf(CloudEndings::All)))
        ->required()
        ->option_text(" ");
    command.add_option("--reduce", settings.reduce, "edge of the voxel grid in m; 0 takes all points")
        ->check(number(0.0, 10.0, "a length from 0 to 10 m"))
        ->option_text("M (0.10)");
    addChoice<ScanFilter>(command, "--filter", settings.filter,
                          {{"none", ScanFilter::None}, {"median", ScanFilter::Median}},
                          "the paper's median and reduction filter for organised scans");
    command.add_option("--range", options.range, "nearest and farthest range of the points used, in m")
        ->expected(2)
        ->check(number(0.0, 10'000.0, "a range from 0 to 10,000 m"))
        ->option_text("MIN MAX (0.4 30)");
    addChoice<SearchMethod>(command, "--search", settings.search,
                            {{"brute-force", SearchMethod::BruteForce},
                             {"kd-tree", SearchMethod::KdTree},
                             {"approximate", SearchMethod::Approximate},
                             {"forest", SearchMethod::Forest}},
                            "how nearest points are found");
    command
        .add_option("--epsilon", settings.epsilon,
                    "of approximate and forest search: at most (1 + epsilon) too far")
        ->check(number(0.0, 100.0, "a number from 0 to 100"))
        ->option_text("E (0.5)");
    std::map<std::string, Minimizer> minimizerKeys;
    for (const MinimizerRow& row : minimizers()) minimizerKeys.emplace(row.key, row.minimizer);
    addChoice<Minimizer>(command, "--minimizer", settings.minimizer, minimizerKeys,
                         "what an iteration minimises, and how");
    command
        .add_option("--max-distance", settings.maxDistances,
                    "maximum pair distance in m, or a schedule such as 1.5,0.5")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->check(number(1e-6, 1'000.0, "a distance above 0 and up to 1,000 m"))
        ->option_text("M[,M...] (0.5,0.2,0.07)");
    command
        .add_option("--max-iterations", settings.maxIterations,
                    "most iterations a scan, over the whole schedule")
        ->check(CLI::Range(1, 1'000'000).description(""))
        ->option_text("N (500)");
    command
        .add_option("--guess", options.guess,
                    "where an alignment starts: odometry (identity for scans without), "
                    "identity, or a file of TUM lines, one a scan in order, pose in the "
                    "first scan's frame")
        ->option_text("odometry|identity|FILE (odometry)");
    addChoice<Reference>(command, "--reference", settings.reference,
                         {{"previous", Reference::Previous}, {"map", Reference::Map}},
                         "what a scan is matched against: the previous scan, or all so far");
    command.add_option("--threads", settings.threads, "0: one a core")
        ->check(CLI::Range(0, 1024).description(""))
        ->option_text("N (0)");
    auto* closing = command.add_flag("--close-loops", options.closeLoops,
                                     "bring the map together where the way comes back to a place, and relax "
                                     "all scans that overlap");
    command
        .add_option(
            "--by-hand", options.byHand,
            "with --close-loops: lines \"i j tx ty tz qx qy qz qw\", where scan j is in scan i's frame, "
            "or \"i j no\", where they do not see the same place; scans count from 0")
        ->needs(closing)
        ->option_text("FILE");
    command.add_option("--poses", options.posesFile, "write the poses as TUM lines")->option_text("OUT.tum");
    command
        .add_option("--map", options.mapFile,
                    fmt::format("write the map: a file ({}), or a folder of uos scans, ending in /",
                                listOf(CloudEndings::Written)))
        ->option_text("OUT");
    command.add_flag("--json", options.json, "print JSON in place of a table");
}

Result<RegistrationSettings> resolvedSettings(const RegisterOptions& options) {
    RegistrationSettings settings = options.settings;
    settings.minRange = options.range[0];
    settings.maxRange = options.range[1];
    if (options.guess == "odometry") {
        settings.guess = GuessSource::Odometry;
    } else if (options.guess == "identity") {
        settings.guess = GuessSource::Identity;
    } else {
        settings.guess = GuessSource::Poses;
        auto poses = readTum(options.guess);
        if (!poses) return Error{"--guess: " + poses.error().text};
        for (const TimedPose& pose : *poses) settings.guessPoses.push_back(pose.pose);
    }
    return settings;
}

}  // namespace leitstand::cli
