#pragma once

namespace CLI {
class App;
}

namespace leitstand::cli {

// Each function adds one subcommand to @p app. When the user chose it, it runs during App::parse and sets
// @p exitCode: 0 ok, 1 the job failed. Results go to stdout; errors, warnings and progress to stderr.

/// `register`: registers scans into a map.
void addRegister(CLI::App& app, int& exitCode);
/// `table1`: measures Table 1 of the paper again.
void addTable1(CLI::App& app, int& exitCode);
/// `graph`: solves a pose graph.
void addGraph(CLI::App& app, int& exitCode);
/// `keys`: makes identities for a secured domain.
void addKeys(CLI::App& app, int& exitCode);

/// `record`: records the messages of robots into a mission.
void addRecord(CLI::App& app, int& exitCode);
/// `info`: lists the contents of a mission.
void addInfo(CLI::App& app, int& exitCode);
/// `replay`: publishes the recorded messages of a mission's robots.
void addReplay(CLI::App& app, int& exitCode);
/// `report`: writes the hand-in of a mission.
void addReport(CLI::App& app, int& exitCode);
/// `export`: writes part of a mission for other programs.
void addExport(CLI::App& app, int& exitCode);
/// `convert`: copies a bag into files of another kind.
void addConvert(CLI::App& app, int& exitCode);
/// `thin`: writes a small copy of a mission.
void addThin(CLI::App& app, int& exitCode);
/// `tidy`: relaxes the map of a mission.
void addTidy(CLI::App& app, int& exitCode);
/// `merge`: joins the maps of two missions.
void addMerge(CLI::App& app, int& exitCode);
/// `changes`: lists what changed between the missions of a map.
void addChanges(CLI::App& app, int& exitCode);
/// `probe`: lists the robots and topics of a domain, and what each topic can be used for.
void addProbe(CLI::App& app, int& exitCode);

}  // namespace leitstand::cli
