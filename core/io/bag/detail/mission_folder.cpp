#include "core/io/bag/detail/mission_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <system_error>
#include <thread>
#include <tuple>

#include <fmt/format.h>

namespace leitstand::detail {

namespace fs = std::filesystem;

namespace {

int openFolder(const fs::path& folder) {
    return ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
}

std::optional<unsigned long> numberOf(const std::string& stem) {
    const auto line = stem.rfind('_');
    if (line == std::string::npos) return std::nullopt;
    const char* begin = stem.data() + line + 1;
    const char* end = stem.data() + stem.size();
    unsigned long number = 0;
    const auto read = std::from_chars(begin, end, number);
    if (begin == end || read.ec != std::errc{} || read.ptr != end) return std::nullopt;
    return number;
}

}  // namespace

Result<FolderLock> FolderLock::take(const fs::path& folder) {
    FolderLock lock(openFolder(folder));
    if (lock.m_descriptor < 0) {
        return Error{
            fmt::format("{}: cannot be opened: {}", folder.string(), std::generic_category().message(errno))};
    }
    // A reader's probe holds the lock for an instant. On file systems without locks (some network ones), the
    // mission is unguarded.
    for (int attempt = 0; ::flock(lock.m_descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
         ++attempt) {
        if (attempt == 20) {
            return Error{folder.string() + ": cannot be written: another program records into this mission"};
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return lock;
}

bool FolderLock::isTaken(const fs::path& folder) {
    const FolderLock probe(openFolder(folder));
    return probe.m_descriptor >= 0 && ::flock(probe.m_descriptor, LOCK_SH | LOCK_NB) != 0 &&
           errno == EWOULDBLOCK;
}

FolderLock::~FolderLock() {
    if (m_descriptor >= 0) ::close(m_descriptor);
}

void syncFolder(const fs::path& folder) {
    const int descriptor = openFolder(folder);
    if (descriptor < 0) return;
    ::fsync(descriptor);
    ::close(descriptor);
}

Result<std::vector<NumberedFile>> databaseFiles(const fs::path& folder, std::string_view ending) {
    std::vector<NumberedFile> files;
    std::error_code problem;
    for (fs::directory_iterator entry(folder, problem), end; !problem && entry != end;
         entry.increment(problem)) {
        const fs::path& path = entry->path();
        std::error_code ignored;
        if (path.extension() != ending || !entry->is_regular_file(ignored)) continue;
        const fs::path name = ending == ".zstd" ? path.stem() : path;  // "bag_2.db3.zstd"
        files.push_back({path, numberOf(name.stem().string())});
    }
    if (problem) return Error{fmt::format("{}: cannot be read: {}", folder.string(), problem.message())};
    const auto key = [](const NumberedFile& file) {
        return std::tuple(!file.number.has_value(), file.number.value_or(0), file.path.filename().string());
    };
    std::sort(files.begin(), files.end(),
              [&](const NumberedFile& a, const NumberedFile& b) { return key(a) < key(b); });
    return files;
}

}  // namespace leitstand::detail
