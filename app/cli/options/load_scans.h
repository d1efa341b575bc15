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

/// A scan that could be read, with its position among all scans and files that the sources name.
struct LoadedScan {
    ScanPtr scan;
    std::size_t position = 0;
};

/// The scans of some sources.
struct LoadedScans {
    std::vector<LoadedScan> scans;
    std::size_t expected = 0;  ///< scans and files that the sources name, readable or not
    int broken = 0;            ///< files and missions that could not be read
};

/// Reads all scans of @p sources: uos folders, cloud files and missions. Reports unreadable files with
/// complain() and goes on. Returns early, with the scans so far, when @p stop is requested. Error: a source
/// is none of these.
[[nodiscard]] Result<LoadedScans> loadScans(const std::vector<std::filesystem::path>& sources,
                                            const std::stop_token& stop, ProgressLine& line);

}  // namespace leitstand::cli
