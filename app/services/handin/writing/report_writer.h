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
    /// Lays a report out as the bytes of a PDF; empty: none is written. Called on the thread that calls
    /// writeReport().
    std::function<Result<std::string>(const ReportContent&)> pdf = {};
    std::string version = {};  ///< of the program
    Time created{};            ///< stated in the PDF; epoch: now
};

/// A file of a report, after it was read again.
struct ReportFile {
    std::string name;
    std::uintmax_t bytes = 0;
    bool whole = false;  ///< whether it could be read again and holds what it should
    std::string check;   ///< what was found in it, or what is wrong
};

/// Result of writing a report.
struct ReportOutcome {
    std::string name;  ///< beginning of its files' names
    std::vector<ReportFile> files;
    std::vector<std::string> warnings;  ///< what is missing or could not be read, each in a sentence
    std::size_t victims = 0, finds = 0, scans = 0;
    double explored = 0.0;  ///< [m2]
    double seconds = 0.0;   ///< duration of the work
    [[nodiscard]] bool whole() const;
};

/// Writes the hand-in of @p mission into the folder @p out, which is created if absent. It has GeoTIFFs at
/// two heights, lists, OctoMap, PLY with labels, a TUM trajectory for each robot, PDF, SHA256SUMS. Replaces
/// files of the same name, each whole or not at all. Once the new files are there, removes files that earlier
/// reports of this mission wrote under other names (EarlierReport). Then reads every file back. Error when
/// the mission cannot be opened, a file cannot be written, or it is cancelled.
[[nodiscard]] Result<ReportOutcome> writeReport(const std::filesystem::path& mission,
                                                const std::filesystem::path& out,
                                                const ReportOptions& options, const Progress& progress = {});

}  // namespace leitstand
