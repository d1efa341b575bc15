#include <CLI/CLI.hpp>

#include "core/version/version.h"
#include "robots/simulation/process/robot_options.h"

int main(int argc, char** argv) {
    CLI::App app("Simulated robots that speak as real ones do.", "leitstand-robot");
    app.set_version_flag("--version", leitstand::versionOf("leitstand-robot"));
    app.require_subcommand(1);
    int exitCode = 0;
    leitstand::simulation::addRobots(app, exitCode);
    leitstand::simulation::addStock(app, exitCode);
    leitstand::simulation::addArena(app, exitCode);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;
    }
    return exitCode;
}
