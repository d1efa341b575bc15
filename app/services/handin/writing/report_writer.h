#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "app/services/handin/report_content.h"
#include "core/base/progress.h"
#include "core/base/result.h"

namespace leitstand {

/// Options of a report.
struct ReportOptions {
    /// Lays out a report as the bytes of a PDF; empty: no PDF is written. Called on the thread that calls
    /// writeReport().
    std::function<Result<std::string>(const ReportContent&)> pdf = {};
    std::string version = {};  ///< version of the program
    Time created{};            ///< time in the PDF; epoch: now
};

/// A file of a report, after it was read back.
struct ReportFile {
    std::string name;
    std::uintmax_t bytes = 0;
    bool whole = false;  ///< whether it could be read and contains what it should
    std::string check;   ///< what was found in it, or what is wrong
};

/// Result of writing a report.
struct ReportOutcome {
    std::string name;  ///< beginning of the names of its files
    std::vector<ReportFile> files;
    std::vector<std::string> warnings;  ///< sentences about what is missing or could not be read
    std::size_t victims = 0, finds = 0, scans = 0;
    double explored = 0.0;  ///< explored area [m2]
    double seconds = 0.0;   ///< duration [s]
    [[nodiscard]] bool whole() const;
};

/// Writes the hand-in of @p mission to the folder @p out, which is made if it is missing. It has GeoTIFFs at
/// two heights, lists, OctoMap, PLY with labels, a TUM trajectory for each robot, PDF, and SHA256SUMS.
/// Replaces files with the same name, each completely or not at all. When the new files are written, removes
/// files that earlier reports of this mission wrote under other names (EarlierReport). Then reads every file
/// back. Error when the mission cannot be opened, a file cannot be written, or it is cancelled.
[[nodiscard]] Result<ReportOutcome> writeReport(const std::filesystem::path& mission,
                                                const std::filesystem::path& out,
                                                const ReportOptions& options, const Progress& progress = {});

}  // namespace leitstand
