#include <CLI/CLI.hpp>

#include "app/cli/commands.h"
#include "core/version/version.h"

int main(int argc, char** argv) {
    CLI::App app("Leitstand's work without a window: registers scans, measures, converts.", "leitstandctl");
    app.set_version_flag("--version", leitstand::versionOf("leitstandctl"));
    app.require_subcommand(1);
    int exitCode = 0;
    leitstand::cli::addRegister(app, exitCode);
    leitstand::cli::addTable1(app, exitCode);
    leitstand::cli::addGraph(app, exitCode);
    leitstand::cli::addKeys(app, exitCode);
    leitstand::cli::addRecord(app, exitCode);
    leitstand::cli::addInfo(app, exitCode);
    leitstand::cli::addReplay(app, exitCode);
    leitstand::cli::addReport(app, exitCode);
    leitstand::cli::addExport(app, exitCode);
    leitstand::cli::addConvert(app, exitCode);
    leitstand::cli::addThin(app, exitCode);
    leitstand::cli::addTidy(app, exitCode);
    leitstand::cli::addMerge(app, exitCode);
    leitstand::cli::addChanges(app, exitCode);
    leitstand::cli::addProbe(app, exitCode);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;
    }
    return exitCode;
}
