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
    int broken = 0;            ///< those that could not be read
};

/// Reads what can be read of @p sources (uos folders, cloud files, missions) until @p stop is requested.
/// Reports the rest with complain(). The error names a source that is none of these.
[[nodiscard]] Result<LoadedScans> loadScans(const std::vector<std::filesystem::path>& sources,
                                            const std::stop_token& stop, ProgressLine& line);

}  // namespace leitstand::cli
