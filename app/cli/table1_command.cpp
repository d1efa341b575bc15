#include <cstdio>
#include <memory>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/cli/console/output.h"
#include "app/cli/console/text_table.h"
#include "app/cli/options/load_scans.h"
#include "app/services/interrupt.h"
#include "core/mapping/scan_preparation.h"
#include "core/mapping/table1.h"

namespace leitstand::cli {
namespace {

struct Table1Options {
    std::vector<std::filesystem::path> sources;
    Table1Settings settings;
    bool json = false;
};

std::string searchName(SearchMethod search) {
    switch (search) {
        case SearchMethod::BruteForce:
            return "brute force";
        case SearchMethod::KdTree:
            return "kd-tree";
        case SearchMethod::Approximate:
            return "apx. kd-tree";
        case SearchMethod::Forest:
            return "semantic forest of apx. kd-trees";
    }
    return {};
}

std::string readableSeconds(double seconds) {
    return seconds < 1.0 ? fmt::format("{:.1f} ms", 1e3 * seconds) : fmt::format("{:.2f} s", seconds);
}

std::string tableText(const Table1& table, const Table1Settings& settings) {
    std::vector<std::vector<std::string>> rows = {{"points", "search", "used", "time", "iterations", "ratio",
                                                   "paper: time", "iterations", "ratio", "off by", "",
                                                   "counts"}};
    for (const Table1Row& row : table) {
        rows.push_back({row.reduced ? "reduced" : "all", searchName(row.search),
                        fmt::format("{}", row.sourcePoints),
                        readableSeconds(row.seconds) + (row.extrapolated ? "*" : ""),
                        fmt::format("{}", row.iterations) + (row.extrapolated ? "*" : ""),
                        fmt::format("{:.3g}", row.speedUp),
                        row.paperSeconds > 0.0 ? fmt::format("{:.2f} s", row.paperSeconds) : "several hours",
                        fmt::format("{}", row.paperIterations),
                        row.paperSpeedUp > 0.0 ? fmt::format("{:.3g}", row.paperSpeedUp) : "",
                        fmt::format("{:.1f} mm", 1e3 * row.distance),
                        fmt::format("{:.2f}°", inDegrees(row.angle)), row.counts ? "yes" : "NO"});
    }
    return textTable(rows) +
           fmt::format(
               "Ratio: time of all points by kd-tree over the row's. Off by: from that row's pose; a row "
               "counts "
               "within {:.0f} mm and {:.1f}°.\n"
               "* Extrapolated: {} iteration(s) were run, and held against as many by kd-tree.\n"
               "One thread, building the search and all iterations, median of {}; labels and reduction are "
               "made "
               "while scanning and are not timed.\n",
               1e3 * Table1Row::CountDistance, inDegrees(Table1Row::CountAngle),
               settings.bruteForceIterations, settings.repetitions);
}

std::string tableJson(const Table1& table) {
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (const Table1Row& row : table) {
        nlohmann::ordered_json entry = {{"points", row.reduced ? "reduced" : "all"},
                                        {"search", searchName(row.search)},
                                        {"target_points", row.targetPoints},
                                        {"source_points", row.sourcePoints},
                                        {"seconds", row.seconds},
                                        {"extrapolated", row.extrapolated},
                                        {"iterations", row.iterations},
                                        {"ratio", row.speedUp},
                                        {"distance", row.distance},
                                        {"angle", row.angle},
                                        {"counts", row.counts}};
        entry["paper"] = {
            {"seconds", row.paperSeconds > 0.0 ? nlohmann::ordered_json(row.paperSeconds) : nullptr},
            {"iterations", row.paperIterations},
            {"ratio", row.paperSpeedUp > 0.0 ? nlohmann::ordered_json(row.paperSpeedUp) : nullptr}};
        rows.push_back(entry);
    }
    return jsonText({{"rows", rows}});
}

int runTable1(const Table1Options& options) {
    ProgressLine line;
    const InterruptGuard interrupt;
    const auto read = loadScans(options.sources, interrupt.token(), line);
    if (!read) {
        complain(line, read.error().text);
        return 1;
    }
    if (read->expected < 2) {
        complain(line, fmt::format("table1 takes two scans, found {}", read->expected));
        return 1;
    }
    if (read->scans.size() < 2) return 1;
    const std::vector<LoadedScan> scans(read->scans.begin(), read->scans.begin() + 2);
    for (const LoadedScan& loaded : scans) {
        if (loaded.scan->organised()) continue;
        complain(line, loaded.scan->name + ": the paper's filter takes an organised scan, this one is not");
        return 1;
    }
    const auto table =
        measureTable1(*labelled(scans[0].scan), *labelled(scans[1].scan), options.settings,
                      {[&](double fraction) { line.show("measuring", fraction); }, interrupt.token()});
    line.clear();
    if (!table) {
        complain(line, table.error().text);
        return 1;
    }
    print(options.json ? tableJson(*table) : tableText(*table, options.settings));
    return 0;
}

}  // namespace

void addTable1(CLI::App& app, int& exitCode) {
    CLI::App* command =
        app.add_subcommand("table1", "measures Table 1 of the Deutschland1 paper again on two scans");
    const auto options = std::make_shared<Table1Options>();
    command
        ->add_option("SOURCE", options->sources,
                     "a folder of uos scans, of which the first two are taken, or two files")
        ->required()
        ->option_text(" ");
    command
        ->add_option("--brute-force-iterations", options->settings.bruteForceIterations,
                     "iterations that brute force really runs")
        ->check(CLI::Range(1, 1000).description(""))
        ->option_text("N (1)");
    command
        ->add_option("--repetitions", options->settings.repetitions,
                     "runs of every other row, whose median counts")
        ->check(CLI::Range(1, 100).description(""))
        ->option_text("N (5)");
    command->add_flag("--json", options->json, "print JSON in place of a table");
    command->final_callback([options, &exitCode] { exitCode = runTable1(*options); });
}

}  // namespace leitstand::cli
