#pragma once

#include <filesystem>
#include <stop_token>
#include <vector>

#include "app/cli/progress_line.h"
#include "core/scan/scan.h"

namespace leitstand::cli {

/// Prints "leitstandctl: TEXT" on stderr.
void complain(ProgressLine& line, const std::string& text);

/// A scan that could be read, and its file's place among the files.
struct LoadedScan {
    ScanPtr scan;
    std::size_t position = 0;
};

/// Reads all of @p files that can be read, until @p stop; complains about the others and counts them in @p
/// broken.
[[nodiscard]] std::vector<LoadedScan> loadScans(const std::vector<std::filesystem::path>& files,
                                                const std::stop_token& stop, ProgressLine& line, int& broken);

}  // namespace leitstand::cli
