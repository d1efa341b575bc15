#include "core/io/bag/reading/other_kinds.h"

#include <algorithm>
#include <fstream>
#include <system_error>

#include "core/base/words.h"
#include "core/io/bag/mcap/mcap_records.h"

namespace leitstand::detail {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view Zstd("\x28\xb5\x2f\xfd", 4);

std::string beginOf(const fs::path& path) {
    std::string begin(16, '\0');
    std::ifstream in(path, std::ios::binary);
    in.read(begin.data(), static_cast<std::streamsize>(begin.size()));
    begin.resize(static_cast<std::size_t>(in.gcount()));
    return begin;
}

/// Files of bags in @p folder that are not among @p read, by name.
std::vector<fs::path> otherFiles(const fs::path& folder, const std::vector<NumberedFile>& read) {
    std::vector<fs::path> files;
    std::error_code problem;
    for (fs::directory_iterator entry(folder, problem), end; !problem && entry != end;
         entry.increment(problem)) {
        const auto ending = entry->path().extension();
        const bool bag = ending == ".db3" || ending == ".mcap" || ending == ".zstd" || ending == ".bag";
        const bool isRead = std::any_of(read.begin(), read.end(), [&](const NumberedFile& one) {
            return one.path.filename() == entry->path().filename();
        });
        if (bag && !isRead) files.push_back(entry->path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

/// Reports files that metadata.yaml lists but the folder does not have: splits that were not copied.
void notifyAbsent(const fs::path& folder, const BagMetadata& metadata, std::vector<std::string>& problems) {
    for (const auto& file : metadata.files) {
        // Old versions of rosbag2 put the folder's own name in front.
        const fs::path name = fs::path(file.path).filename();
        std::error_code ignored;
        if (name.empty() || fs::exists(folder / name, ignored)) continue;
        problems.push_back(leitstand::fill(
            translate("leitstand::Error", "{}: expected it, since metadata.yaml lists it, found nothing"),
            (folder / name).string()));
    }
}

}  // namespace

bool isRos1(const fs::path& path) {
    return beginOf(path).starts_with("#ROSBAG V");
}

bool isPacked(const fs::path& path) {
    return beginOf(path).starts_with(Zstd);
}

bool isMcap(const fs::path& path) {
    return path.extension() == ".mcap" || beginOf(path).starts_with(McapMagic);
}

bool isCompressed(const Payload& cdr) {
    return cdr->size() >= Zstd.size() &&
           std::equal(Zstd.begin(), Zstd.end(), cdr->begin(), [](char expected, std::byte found) {
               return static_cast<std::byte>(expected) == found;
           });
}

Result<void> checkKind(const fs::path& folder, const std::optional<BagMetadata>& metadata,
                       const std::vector<NumberedFile>& files, std::vector<std::string>& problems) {
    const std::string compression = metadata ? metadata->compression : std::string();
    if (!compression.empty() && compression != "zstd") {
        return Error{leitstand::fill(translate("leitstand::Error",
                                               "{}: expected a bag without compression, or with zstd, found "
                                               "compression \"{}\"; `ros2 bag convert` writes one without"),
                                     folder.string(), compression)};
    }
    if (metadata && metadata->storage != "sqlite3" && metadata->storage != "mcap" && files.empty()) {
        return Error{leitstand::fill(translate("leitstand::Error",
                                               "{}: expected a bag in SQLite or MCAP files (sqlite3, mcap), "
                                               "found storage \"{}\"; `ros2 bag convert` turns it into one"),
                                     folder.string(), metadata->storage)};
    }
    const auto others = otherFiles(folder, files);
    if (files.empty() && !others.empty()) {
        return Error{leitstand::fill(
            translate(
                "leitstand::Error",
                "{}: expected a bag in SQLite or MCAP files (.db3, .mcap), found {}; `ros2 bag convert` "
                "turns it into one"),
            folder.string(), others.front().filename().string())};
    }
    if (files.empty())
        return Error{leitstand::fill(
            translate("leitstand::Error",
                      "{}: expected a bag: metadata.yaml and files that end in .db3, .mcap or .bag"),
            folder.string())};
    for (const fs::path& other : others) {
        problems.push_back(
            leitstand::fill(translate("leitstand::Error",
                                      "{}: is of another kind than the bag's other files, and is not read"),
                            other.string()));
    }
    if (metadata) notifyAbsent(folder, *metadata, problems);
    return {};
}

}  // namespace leitstand::detail
