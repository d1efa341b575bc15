#include "core/io/bag/reading/other_kinds.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <system_error>
#include <utility>

#include "core/base/words.h"

namespace leitstand::detail {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view Zstd("\x28\xb5\x2f\xfd", 4);

constexpr std::array<std::pair<std::string_view, const char*>, 3> Kinds = {{
    {std::string_view("\x89MCAP0\r\n", 8), translatable("leitstand::Error", "an MCAP file")},
    {Zstd, translatable("leitstand::Error", "a file compressed by zstd")},
    {"#ROSBAG V", translatable("leitstand::Error", "a bag of ROS 1")},
}};

/// Files in @p folder that belong to bags of other kinds, by name.
std::vector<fs::path> otherFiles(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code problem;
    for (fs::directory_iterator entry(folder, problem), end; !problem && entry != end;
         entry.increment(problem)) {
        const auto ending = entry->path().extension();
        if (ending == ".mcap" || ending == ".zstd" || ending == ".bag") files.push_back(entry->path());
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

std::string otherKind(std::string_view begin) {
    for (const auto& [magic, name] : Kinds) {
        if (begin.starts_with(magic)) return translate("leitstand::Error", name);
    }
    return {};
}

std::string otherKindOf(const fs::path& path) {
    std::array<char, 16> begin{};
    std::ifstream in(path, std::ios::binary);
    in.read(begin.data(), begin.size());
    return otherKind({begin.data(), static_cast<std::size_t>(in.gcount())});
}

bool isCompressed(const Payload& cdr) {
    return cdr->size() >= Zstd.size() &&
           std::equal(Zstd.begin(), Zstd.end(), cdr->begin(), [](char expected, std::byte found) {
               return static_cast<std::byte>(expected) == found;
           });
}

Result<void> checkKind(const fs::path& folder, const std::optional<BagMetadata>& metadata,
                       const std::vector<NumberedFile>& files, std::vector<std::string>& problems) {
    if (metadata && !metadata->compression.empty()) {
        return Error{leitstand::fill(translate("leitstand::Error",
                                               "{}: expected an uncompressed bag, found compression \"{}\"; "
                                               "`ros2 bag convert` writes one without"),
                                     folder.string(), metadata->compression)};
    }
    if (metadata && metadata->storage != "sqlite3" && files.empty()) {
        return Error{leitstand::fill(translate("leitstand::Error",
                                               "{}: expected a bag in SQLite files (sqlite3), found storage "
                                               "\"{}\"; `ros2 bag convert` turns it into one"),
                                     folder.string(), metadata->storage)};
    }
    const auto others = otherFiles(folder);
    if (files.empty() && !others.empty()) {
        return Error{leitstand::fill(
            translate(
                "leitstand::Error",
                "{}: expected a bag in SQLite files (.db3), found {}; `ros2 bag convert` turns it into one"),
            folder.string(), others.front().filename().string())};
    }
    if (files.empty())
        return Error{leitstand::fill(
            translate("leitstand::Error", "{}: expected a bag: metadata.yaml and files that end in .db3"),
            folder.string())};
    for (const fs::path& other : others) {
        problems.push_back(leitstand::fill(
            translate("leitstand::Error", "{}: expected an SQLite file (.db3); it is not read"),
            other.string()));
    }
    if (metadata) notifyAbsent(folder, *metadata, problems);
    return {};
}

}  // namespace leitstand::detail
