#include "core/io/clouds/scan_source.h"

#include <algorithm>
#include <new>
#include <string>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "core/io/clouds/cloud_formats.h"
#include "core/io/clouds/detail/uos_names.h"

namespace leitstand {

namespace fs = std::filesystem;

namespace {

Result<std::vector<fs::path>> uosScansIn(const fs::path& folder) {
    std::vector<std::pair<std::size_t, fs::path>> found;
    std::error_code problem;
    for (fs::directory_iterator entry(folder, problem), end; !problem && entry != end;
         entry.increment(problem)) {
        if (const auto number = detail::uosNumber(entry->path())) found.emplace_back(*number, entry->path());
    }
    if (problem) return Error{fmt::format("{}: cannot be read: {}", folder.string(), problem.message())};
    if (found.empty()) return Error{folder.string() + ": expected scans (scan000.3d, ...), found none"};
    std::sort(found.begin(), found.end());
    std::vector<fs::path> files;
    for (auto& [number, file] : found) files.push_back(std::move(file));
    return files;
}

}  // namespace

Result<std::vector<fs::path>> listScans(const std::vector<fs::path>& sources) {
    std::vector<fs::path> files;
    for (const fs::path& source : sources) {
        std::error_code problem;
        const fs::file_status status = fs::status(source, problem);
        if (!fs::exists(status)) {
            return Error{fmt::format("{}: cannot be opened: {}", source.string(), problem.message())};
        }
        // A folder is a folder of scans, even if it is called x.3d.
        if (fs::is_directory(status)) {
            auto inside = uosScansIn(source);
            if (!inside) return inside;
            files.insert(files.end(), inside->begin(), inside->end());
            continue;
        }
        if (cloudFormatOf(source) == nullptr) {
            return Error{fmt::format("{}: expected a folder of scans or a file that ends in {}",
                                     source.string(), listOf(CloudEndings::All, ", ", " or "))};
        }
        files.push_back(source);
    }
    return files;
}

Result<ScanReading> readScan(const fs::path& file) try {
    const CloudFormat* const format = cloudFormatOf(file);
    if (format == nullptr)
        return Error{
            fmt::format("{}: expected an ending {}", file.string(), listOf(CloudEndings::All, ", ", " or "))};
    return format->read(file);
} catch (const std::bad_alloc&) {
    return Error{file.string() + ": does not fit into memory"};
}

}  // namespace leitstand
