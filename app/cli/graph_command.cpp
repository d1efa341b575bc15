#include <chrono>
#include <filesystem>
#include <memory>
#include <string>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/cli/console/output.h"
#include "app/services/interrupt.h"
#include "core/base/time.h"
#include "core/io/graph/g2o_file.h"
#include "core/mapping/graph/graph_solver.h"

namespace leitstand::cli {
namespace {

struct GraphOptions {
    std::filesystem::path file, out;
    std::string solver = "plain";
    GraphSettings settings;
    bool json = false;
};

int dismissed(const PoseGraph& graph, const GraphResult& result) {
    int count = 0;
    for (std::size_t i = 0; i < graph.links.size(); ++i) count += result.weights[i] < 0.5 ? 1 : 0;
    return count;
}

void printResult(const GraphOptions& options, const PoseGraph& graph, const GraphResult& result,
                 double seconds) {
    const int left = dismissed(graph, result);
    if (options.json) {
        printJson({{"file", options.file.string()},
                   {"nodes", graph.nodes.size()},
                   {"links", graph.links.size()},
                   {"solver", options.solver},
                   {"cost_before", result.costBefore},
                   {"cost", result.cost},
                   {"iterations", result.iterations},
                   {"converged", result.converged},
                   {"dismissed", left},
                   {"seconds", seconds}});
        return;
    }
    print("{} nodes, {} links\ncost {:.6g}, before {:.6g}; {} iterations in {:.3f} s{}\n", graph.nodes.size(),
          graph.links.size(), result.cost, result.costBefore, result.iterations, seconds,
          result.converged ? "" : ", not converged");
    if (options.settings.robust) print("{} links dismissed\n", left);
}

int run(const GraphOptions& options) {
    auto read = readG2o(options.file);
    if (!read) {
        printError(read.error().text);
        return 1;
    }
    PoseGraph graph = std::move(read).value();
    const InterruptGuard interrupt;
    const auto began = std::chrono::steady_clock::now();
    const GraphResult result = solve(graph, options.settings, {.report = {}, .stop = interrupt.token()});
    const double seconds = toSeconds(std::chrono::steady_clock::now() - began);
    if (!options.out.empty()) {
        for (std::size_t i = 0; i < graph.links.size(); ++i) graph.links[i].active = result.weights[i] >= 0.5;
        if (const auto written = writeG2o(options.out, graph); !written) {
            printError(written.error().text);
            return 1;
        }
    }
    printResult(options, graph, result, seconds);
    return result.converged ? 0 : 1;
}

}  // namespace

void addGraph(CLI::App& app, int& exitCode) {
    CLI::App* command = app.add_subcommand("graph", "solves a graph of poses (g2o)");
    const auto options = std::make_shared<GraphOptions>();
    command->footer(
        "The cost is 1/2 the sum of e^T Omega e with e = (t, 2 vec q) of measured^-1 * from^-1 * to.");
    command->add_option("FILE", options->file, "poses and links, as VERTEX_SE3:QUAT and EDGE_SE3:QUAT")
        ->required()
        ->option_text(" ");
    command->add_option("--out", options->out, "write poses and the links that count there")
        ->option_text("FILE.g2o");
    command
        ->add_option(
            "--solver", options->solver,
            "plain, or robust: links between nodes that do not follow each other are dismissed where they "
            "contradict the rest")
        ->check(CLI::IsMember({"plain", "robust"}).description(""))
        ->option_text("NAME (plain)");
    command->add_option("--iterations", options->settings.maxIterations, "at most so many")
        ->check(CLI::Range(1, 10'000).description(""))
        ->option_text("N (100)");
    command->add_flag("--json", options->json, "print JSON in place of text");
    command->final_callback([options, &exitCode] {
        options->settings.robust = options->solver == "robust";
        exitCode = run(*options);
    });
}

}  // namespace leitstand::cli
