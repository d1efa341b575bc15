#include "core/io/detail/input_file.h"

#include <sys/stat.h>

#include <cerrno>
#include <system_error>

#include <fmt/format.h>

namespace leitstand::detail {

namespace fs = std::filesystem;

Result<InputFile> InputFile::open(const fs::path& path) {
    std::error_code problem;
    const fs::file_status status = fs::status(path, problem);
    if (fs::is_directory(status)) return Error{path.string() + ": expected a file, found a directory"};
    if (fs::exists(status) && !fs::is_regular_file(status)) {
        return Error{path.string() + ": expected a regular file"};
    }
    InputFile file;
    file.m_path = path;
    file.m_file.reset(std::fopen(path.c_str(), "rb"));
    if (!file.m_file) {
        return Error{
            fmt::format("{}: cannot be opened: {}", path.string(), std::generic_category().message(errno))};
    }
    std::setvbuf(file.m_file.get(), nullptr, _IONBF, 0);  // readers have buffers of their own
    file.m_size = fs::file_size(path, problem);
    if (problem) return Error{fmt::format("{}: {}", path.string(), problem.message())};
    return file;
}

void InputFile::lookAgain() {
    struct stat facts {};
    if (::fstat(fileno(m_file.get()), &facts) == 0) m_size = static_cast<std::uint64_t>(facts.st_size);
}

Result<std::size_t> InputFile::read(char* to, std::size_t count) {
    const std::size_t got = std::fread(to, 1, count, m_file.get());
    if (got < count && std::ferror(m_file.get()) != 0) {
        return Error{
            fmt::format("{}: cannot be read: {}", m_path.string(), std::generic_category().message(errno))};
    }
    return got;
}

Result<void> InputFile::seek(std::uint64_t offset) {
    if (fseeko(m_file.get(), static_cast<off_t>(offset), SEEK_SET) != 0) {
        return Error{fmt::format("{}: byte {} cannot be reached", m_path.string(), offset)};
    }
    return {};
}

}  // namespace leitstand::detail
