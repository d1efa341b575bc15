#include "core/io/bag/reading/bag_opening.h"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <system_error>

#include "core/base/words.h"
#include "core/io/bag/bag_storage.h"
#include "core/io/bag/detail/mission_folder.h"
#include "core/io/bag/mcap/mcap_file.h"
#include "core/io/bag/reading/other_kinds.h"
#include "core/io/bag/reading/sqlite_file.h"
#include "core/io/bag/reading/unpacked_file.h"
#include "core/io/bag/ros1/ros1_file.h"
#include "core/io/bag/salvage/log_frames.h"
#include "core/io/bag/salvage/salvaged_file.h"

namespace leitstand::detail {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t MaxMetadataBytes = 16U << 20U;

/// Reads metadata.yaml in @p folder. Empty, with an entry in @p problems, when it cannot be read.
std::optional<BagMetadata> readMetadata(const fs::path& folder, std::vector<std::string>& problems) {
    const fs::path file = folder / "metadata.yaml";
    std::error_code problem;
    const auto size = fs::file_size(file, problem);
    if (problem) {
        problems.push_back(leitstand::fill(
            translate("leitstand::Error", "{}: is missing or cannot be read; the files were asked instead"),
            file.string()));
        return std::nullopt;
    }
    if (size > MaxMetadataBytes) {
        problems.push_back(
            leitstand::fill(translate("leitstand::Error", "{}: expected at most {} bytes, found {}"),
                            file.string(), MaxMetadataBytes, size));
        return std::nullopt;
    }
    std::ifstream in(file, std::ios::binary);
    std::stringstream text;
    text << in.rdbuf();
    auto metadata = parseMetadata(text.str(), file.string());
    if (metadata) return std::move(metadata).value();
    problems.push_back(metadata.error().text);
    return std::nullopt;
}

Result<void> openParts(OpenBag& bag, const std::vector<NumberedFile>& files, bool locked) {
    const auto written = std::find_if(files.rbegin(), files.rend(),
                                      [](const NumberedFile& file) { return file.number.has_value(); });
    std::string firstError;
    for (const NumberedFile& file : files) {
        BagPart part{.path = file.path};
        part.live = locked && written != files.rend() && &file == &*written;
        auto opened = openFile(file.path, part.live, bag.problems, part.damaged);
        if (!opened) {
            bag.problems.push_back(opened.error().text);
            if (firstError.empty()) firstError = opened.error().text;
            continue;
        }
        part.file = std::move(opened).value();
        const auto& problems = part.file->facts().problems;
        bag.problems.insert(bag.problems.end(), problems.begin(), problems.end());
        if (std::string missing = judgeMissing(part, bag.metadata); !missing.empty())
            bag.problems.push_back(std::move(missing));
        bag.parts.push_back(std::move(part));
    }
    if (bag.parts.empty()) return Error{firstError};
    return {};
}

/// Opens the file compressed by zstd at @p path; see openFile(). Its unpacked copy lives as long as the
/// result.
Result<std::shared_ptr<BagFile>> openPacked(const fs::path& path, std::vector<std::string>& problems,
                                            bool& damaged) {
    struct Unpacked {
        std::shared_ptr<const UnpackedFile> copy;  // removed after the file is closed
        std::shared_ptr<BagFile> file;
    };
    auto copy = UnpackedFile::shared(path);
    if (!copy) return copy.error();
    const fs::path plain = (*copy)->path();
    if (isPacked(plain))
        return Error{
            leitstand::fill(translate("leitstand::Error", "{}: is compressed twice"), path.string())};
    auto opened = openFile(plain, false, problems, damaged);
    if (!opened) return Error{path.string() + ": " + opened.error().text};
    const auto both = std::make_shared<Unpacked>(Unpacked{*copy, std::move(opened).value()});
    return std::shared_ptr<BagFile>(both, both->file.get());
}

/// Returns the files of the bag in @p folder: of the kind that @p metadata names, or else of another one.
Result<std::vector<NumberedFile>> filesOf(const fs::path& folder,
                                          const std::optional<BagMetadata>& metadata) {
    std::vector<std::string_view> kinds = {".db3", ".mcap", ".zstd", ".bag"};
    if (metadata && metadata->storage == "mcap") std::swap(kinds[0], kinds[1]);
    if (metadata && !metadata->compression.empty() && !metadata->compressesMessages)
        std::rotate(kinds.begin(), kinds.begin() + 2, kinds.begin() + 3);
    Result<std::vector<NumberedFile>> files = std::vector<NumberedFile>();
    for (const std::string_view kind : kinds) {
        if (files && files->empty()) files = databaseFiles(folder, kind);
    }
    return files;
}

void numberOn(std::vector<BagPart>& parts) {
    std::uint64_t last = 0;
    for (BagPart& part : parts) {
        const BagFileFacts& facts = part.file->facts();
        if (facts.lastId == 0) {
            part.offset = last;
            if (facts.ours) part.offset = 0;
            continue;
        }
        part.offset = facts.firstId > last ? 0 : last;
        last = facts.lastId + part.offset;
    }
}

/// What of the write-ahead log of the database @p path is hidden behind a broken place. Empty when nothing
/// is. That the log's end is cut off is added to @p problems.
std::string brokenLog(const fs::path& path, std::vector<std::string>& problems) {
    const fs::path log = path.string() + "-wal";
    const std::size_t pageSize = PageFile::pageSizeOf(path);
    if (pageSize == 0) return {};
    const LogFrames frames = logFrames(OverlayFile(log), pageSize);
    if (frames.cut) {
        problems.push_back(leitstand::fill(
            translate("leitstand::Error",
                      "{}: ends within what was being written: the last moment before is missing"),
            log.string()));
    }
    if (!frames.hides()) return {};
    if (frames.firstBroken == 0)
        return leitstand::fill(translate("leitstand::Error", "{}: its header is broken"), log.string());
    return leitstand::fill(translate("leitstand::Error", "{}: frame {} is broken, {} follow"), log.string(),
                           frames.firstBroken, frames.hidden);
}

/// Returns @p opened, or the file read page by page (@p damaged is set). The latter when the log hides frames
/// behind a broken one, as @p broken says, and salvage finds no fewer messages.
std::shared_ptr<BagFile> withHiddenFrames(const fs::path& path, std::shared_ptr<BagFile> opened,
                                          const std::string& broken, std::vector<std::string>& problems,
                                          bool& damaged) {
    if (broken.empty()) return opened;
    auto salvaged = SalvagedFile::open(path, broken);
    if (!salvaged) {
        problems.push_back(broken);
        return opened;
    }
    const auto messages = [](const BagFile& file) {
        const BagFileFacts& facts = file.facts();
        return facts.messages().value_or(facts.lastId == 0 ? 0 : facts.lastId - facts.firstId + 1);
    };
    if (messages(**salvaged) < messages(*opened)) {
        problems.push_back(broken);  // what it hides is in the database, too
        return opened;
    }
    damaged = true;
    return std::move(salvaged).value();
}

}  // namespace

std::string judgeMissing(BagPart& part, const std::optional<BagMetadata>& metadata) {
    part.missing = 0;
    if (part.live) return {};
    const BagFileFacts& facts = part.file->facts();
    const std::uint64_t rows = facts.lastId == 0 ? 0 : facts.lastId - facts.firstId + 1;
    const std::uint64_t found = facts.messages().value_or(rows);
    const std::uint64_t stated = metadata ? metadata->writtenInto(part.path.filename().string()) : 0;
    const std::uint64_t expected = std::max(stated, facts.expected);
    if (expected <= found) return {};
    part.missing = expected - found;
    return leitstand::fill(
        translate("leitstand::Error",
                  "{}: expected {} messages, as they were counted, found {}: {} are missing"),
        part.path.string(), expected, found, part.missing);
}

Result<std::shared_ptr<BagFile>> openFile(const fs::path& path, bool live, std::vector<std::string>& problems,
                                          bool& damaged) {
    std::error_code problem;
    const auto size = fs::file_size(path, problem);
    if (problem)
        return Error{leitstand::fill(translate("leitstand::Error", "{}: cannot be opened: {}"), path.string(),
                                     problem.message())};
    if (size == 0)
        return Error{leitstand::fill(
            translate("leitstand::Error", "{}: expected a bag's file, found an empty one"), path.string())};
    // Closing any other descriptor of a file that this process writes would drop SQLite's locks on it.
    if (!live && isPacked(path)) return openPacked(path, problems, damaged);
    if (live ? path.extension() == endingOf(BagStorage::Mcap) : isMcap(path)) {
        auto opened = McapFile::open(path, live);
        if (!opened) return opened.error();
        return std::shared_ptr<BagFile>(std::move(opened).value());
    }
    if (!live && isRos1(path)) {
        auto opened = Ros1File::open(path);
        if (!opened) return opened.error();
        return std::shared_ptr<BagFile>(std::move(opened).value());
    }
    auto opened = SqliteFile::open(path, live);
    if (opened && live) return std::shared_ptr<BagFile>(std::move(opened).value());
    if (!opened && live) return opened.error();  // its pages are changing
    const std::string broken = brokenLog(path, problems);
    if (opened) return withHiddenFrames(path, std::move(opened).value(), broken, problems, damaged);
    // Pages that a checkpoint wrote are newer than those that SQLite finds before the broken frame.
    if (!broken.empty()) problems.push_back(broken);
    auto salvaged = SalvagedFile::open(path, opened.error().text);
    if (!salvaged) return salvaged.error();
    damaged = true;
    return std::shared_ptr<BagFile>(std::move(salvaged).value());
}

Result<OpenBag> openBag(const fs::path& path, Writer writer) {
    OpenBag bag{.path = path};
    std::error_code problem;
    const fs::file_status status = fs::status(path, problem);
    if (!fs::exists(status))
        return Error{leitstand::fill(
            translate("leitstand::Error", "{}: expected a bag's folder or file, found nothing"),
            path.string())};
    if (!fs::is_directory(status)) {
        if (!fs::is_regular_file(status))
            return Error{leitstand::fill(
                translate("leitstand::Error", "{}: expected a folder or a regular file"), path.string())};
        const fs::path folder = fs::absolute(path, problem).parent_path();
        std::vector<NumberedFile> alone = {{path, std::nullopt}};
        if (FolderLock::isTaken(folder)) {  // is it the one that is written?
            const auto files = databaseFiles(folder, path.extension().string());
            for (const NumberedFile& file : files ? *files : std::vector<NumberedFile>{}) {
                if (file.number)
                    alone[0].number = fs::equivalent(file.path, path, problem) ? file.number : std::nullopt;
            }
        }
        if (auto opened = openParts(bag, alone, alone[0].number.has_value()); !opened) return opened.error();
        numberOn(bag.parts);
        return bag;
    }
    bag.metadata = readMetadata(path, bag.problems);
    auto files = filesOf(path, bag.metadata);
    if (!files) return files.error();
    if (auto kind = checkKind(path, bag.metadata, *files, bag.problems); !kind) return kind.error();
    const bool locked = writer == Writer::Anyone && FolderLock::isTaken(path);
    if (auto opened = openParts(bag, *files, locked); !opened) return opened.error();
    numberOn(bag.parts);
    return bag;
}

}  // namespace leitstand::detail
