#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/services/handin/writing/report_writer.h"
#include "core/base/progress.h"
#include "core/base/result.h"

namespace leitstand {

/// Options of an export.
struct ExportOptions {
    double reduce = 0.0;  ///< clouds keep one point in each cube with this edge [m]; 0: all points
    std::string robot;    ///< robot whose trajectory alone is exported; empty: those of all robots
    /// For .tif and .pgm: show the map at 0.90 to 1.10 m above the floor, instead of 0.25 to 0.35 m.
    bool upper = false;
    /// For .tif and .pgm: number of the only storey to show; empty: all storeys in one map.
    std::optional<int> storey = {};
};

/// Result of an export.
struct ExportOutcome {
    std::vector<ReportFile> files;  ///< their names are paths, as the caller gave them
    std::vector<std::string> warnings;
};

/// A format that exportMission() writes.
struct ExportFormat {
    std::string ending;   ///< ending of the file with its dot
    std::string subject;  ///< what it contains, in English
};
[[nodiscard]] std::vector<ExportFormat> exportFormats();
/// Whether @p out has one of the endings of exportFormats(), or is a folder: it exists as one, or ends in
/// "/".
[[nodiscard]] bool canExport(const std::filesystem::path& out);
/// Whether ExportOptions::storey counts for @p out: it is a map seen from above.
[[nodiscard]] bool showsStoreys(const std::filesystem::path& out);
/// Returns in words what canExport() expects: the endings, or a folder.
[[nodiscard]] std::string expectedOfExport();

/// Exports @p mission to @p out, whose ending selects one of exportFormats(). Trajectories of several robots
/// are written to one file FILE_robot.tum each. FILE_victims.csv, FILE_qr.csv and FILE_searched.csv contain
/// the lists of that name; any other .csv contains all points of interest. A folder "DIR/" gets uos scans
/// with poses. Error when the mission cannot be opened or lacks that part, when the file cannot be written,
/// or when cancelled.
[[nodiscard]] Result<ExportOutcome> exportMission(const std::filesystem::path& mission,
                                                  const std::filesystem::path& out,
                                                  const ExportOptions& options,
                                                  const Progress& progress = {});

}  // namespace leitstand
