#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/services/handin/writing/report_writer.h"
#include "core/base/progress.h"
#include "core/base/result.h"

namespace leitstand {

/// What is exported of a mission.
struct ExportOptions {
    double reduce = 0.0;  ///< clouds keep one point in each cube of this edge [m]; 0: all points
    std::string robot;    ///< only its trajectory; empty: each robot's
    bool upper = false;   ///< .tif: the map at 0.90 to 1.10 m above the floor, not at 0.25 to 0.35 m
    std::optional<int> storey = {};  ///< .tif: number of the only one that is shown; empty: all in one
};

/// What came of an export.
struct ExportOutcome {
    std::vector<ReportFile> files;  ///< paths as they were written
    std::vector<std::string> warnings;
};

/// What exportMission() writes into a file.
struct ExportFormat {
    std::string ending;   ///< with its dot
    std::string subject;  ///< what it holds, in English
};
[[nodiscard]] std::vector<ExportFormat> exportFormats();
/// Whether @p out has one of their endings, or is a folder: exists as one, or ends in "/".
[[nodiscard]] bool canExport(const std::filesystem::path& out);
/// What is expected where it cannot: the endings, and a folder.
[[nodiscard]] std::string expectedOfExport();

/// Writes part of @p mission by @p out's ending, which has one of exportFormats(): of several robots
/// FILE_robot.tum each, of lists FILE_victims.csv, FILE_qr.csv and FILE_searched.csv those, others all points
/// of interest. "DIR/": uos scans with poses. An error when the mission cannot be opened, does not have that
/// part, or the file cannot be written.
[[nodiscard]] Result<ExportOutcome> exportMission(const std::filesystem::path& mission,
                                                  const std::filesystem::path& out,
                                                  const ExportOptions& options,
                                                  const Progress& progress = {});

}  // namespace leitstand
