#pragma once

#include <filesystem>
#include <stop_token>
#include <vector>

#include "app/cli/console/progress_line.h"
#include "core/base/result.h"
#include "core/cloud/scan.h"

namespace leitstand::cli {

/// Clears @p line and prints "leitstandctl: TEXT" on stderr.
void complain(ProgressLine& line, const std::string& text);

/// A scan that was read, with its position among all scans and files of the sources.
struct LoadedScan {
    ScanPtr scan;
    std::size_t position = 0;
};

/// The scans from some sources.
struct LoadedScans {
    std::vector<LoadedScan> scans;
    std::size_t expected = 0;  ///< number of scans and files in the sources, including unreadable ones
    int broken = 0;            ///< number of files and missions that could not be read
};

/// Reads all scans in @p sources: uos folders, cloud files and missions. Reports unreadable files with
/// complain() and continues. Returns early, with the scans so far, when @p stop is requested. Error: a source
/// is none of these.
[[nodiscard]] Result<LoadedScans> loadScans(const std::vector<std::filesystem::path>& sources,
                                            const std::stop_token& stop, ProgressLine& line);

}  // namespace leitstand::cli
