#include "transport/security/key_files.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <system_error>

#include <fcntl.h>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

namespace leitstand {
namespace fs = std::filesystem;
namespace {

Error cannot(const fs::path& file, const char* what, int number) {
    return Error{fmt::format("{}: cannot be {}: {}", file.string(), what, std::strerror(number))};
}

}  // namespace

Result<std::string> readKeyFile(const fs::path& file) {
    constexpr std::size_t Limit = 1 << 20;
    std::error_code none;
    if (fs::is_directory(file, none)) return Error{file.string() + ": expected a file, found a folder"};
    errno = 0;
    std::ifstream in(file, std::ios::binary);
    if (!in) return cannot(file, "opened", errno == 0 ? EIO : errno);
    std::string text(Limit + 1, '\0');
    in.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(in.gcount()));
    if (text.size() > Limit) return Error{file.string() + ": expected at most 1 MB"};
    return text;
}

Result<void> writeNewFile(const fs::path& file, const std::string& text, bool secret) {
    const int handle = open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, secret ? 0600 : 0644);
    if (handle < 0) return cannot(file, "made", errno);
    std::size_t written = 0;
    int failed = 0;
    while (failed == 0 && written < text.size()) {
        const ssize_t step = write(handle, text.data() + written, text.size() - written);
        if (step < 0 && errno != EINTR) failed = errno;
        if (step > 0) written += static_cast<std::size_t>(step);
    }
    if (failed == 0 && fsync(handle) != 0) failed = errno;
    if (close(handle) != 0 && failed == 0) failed = errno;
    if (failed == 0) return {};
    unlink(file.c_str());
    return cannot(file, "written", failed);
}

Result<void> replaceFile(const fs::path& file, const std::string& text) {
    const fs::path fresh = file.string() + ".new";
    std::error_code none;
    fs::remove(fresh, none);
    if (auto written = writeNewFile(fresh, text, false); !written) return written;
    if (std::rename(fresh.c_str(), file.c_str()) != 0) return cannot(file, "replaced", errno);
    return {};
}

Result<void> makeFolder(const fs::path& folder, bool secret) {
    std::error_code problem;
    if (fs::is_directory(folder, problem)) return {};
    if (folder.has_parent_path() && !fs::is_directory(folder.parent_path(), problem)) {
        if (auto above = makeFolder(folder.parent_path(), false); !above) return above;
    }
    if (mkdir(folder.c_str(), secret ? 0700 : 0755) != 0) {
        return cannot(folder, "made", errno);
    }
    return {};
}

Result<void> moveTo(const fs::path& from, const fs::path& to) {
    std::error_code none;
    if (fs::exists(to, none)) return Error{to.string() + ": is there already; expected a free place"};
    if (std::rename(from.c_str(), to.c_str()) != 0) {
        return cannot(from, ("moved to " + to.string()).c_str(), errno);
    }
    return {};
}

std::string accessProblem(const fs::path& file) {
    struct stat about {};
    if (stat(file.c_str(), &about) != 0) return {};
    if ((about.st_mode & 077) == 0) return {};
    return fmt::format("{}: others may read or change this key; run: chmod 600 {}", file.string(),
                       file.string());
}

std::string dateOf(Time time) {
    return fmt::format("{:%Y-%m-%d}",
                       fmt::gmtime(std::chrono::system_clock::to_time_t(
                           std::chrono::time_point_cast<std::chrono::system_clock::duration>(time))));
}

}  // namespace leitstand
