#include "core/io/detail/output_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <system_error>

#include <fmt/format.h>

#include "core/base/words.h"

namespace leitstand::detail {

namespace fs = std::filesystem;

namespace {

/// Returns a hidden name beside @p target that no other writer on this machine uses.
fs::path temporaryFor(const fs::path& target) {
    static std::atomic<unsigned> count = 0;
    return target.parent_path() / fmt::format(".{}.{}-{}", target.filename().string(), getpid(), ++count);
}

}  // namespace

Result<OutputFile> OutputFile::create(const fs::path& target) {
    std::error_code ignored;
    const fs::file_status status = fs::status(target, ignored);
    if (fs::exists(status) && !fs::is_regular_file(status)) {
        return Error{
            leitstand::fill(translate("leitstand::Error", "{}: cannot be written: it is not a regular file"),
                            target.string())};
    }
    OutputFile file;
    file.m_target = target;
    const fs::path temporary = temporaryFor(target);
    // Not mkstemp, which ignores the user's umask.
    const int descriptor = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor < 0) return file.problem(errno);
    file.m_temporary = temporary;
    file.m_file.reset(::fdopen(descriptor, "wb"));
    if (!file.m_file) {
        const int number = errno;
        ::close(descriptor);
        return file.problem(number);
    }
    std::setvbuf(file.m_file.get(), nullptr, _IOFBF, 1 << 18);
    return file;
}

OutputFile::~OutputFile() {
    if (!m_file) return;  // moved from, or committed
    m_file.reset();
    std::error_code ignored;
    fs::remove(m_temporary, ignored);
}

void OutputFile::write(std::string_view bytes) {
    if (m_failed != 0) return;
    if (std::fwrite(bytes.data(), 1, bytes.size(), m_file.get()) != bytes.size()) m_failed = errno;
}

Result<void> OutputFile::commit() {
    if (m_failed == 0 && std::fflush(m_file.get()) != 0) m_failed = errno;
    if (m_failed == 0 && ::fsync(fileno(m_file.get())) != 0) m_failed = errno;
    if (m_failed != 0) return problem(m_failed);
    std::error_code renaming;
    fs::rename(m_temporary, m_target, renaming);
    if (renaming) return problem(renaming.value());
    m_file.reset();
    return {};
}

Error OutputFile::problem(int number) const {
    return Error{leitstand::fill(translate("leitstand::Error", "{}: cannot be written: {}"),
                                 m_target.string(), std::generic_category().message(number))};
}

Result<void> writeWhole(const fs::path& target, std::string_view text) {
    auto created = OutputFile::create(target);
    if (!created) return created.error();
    OutputFile out = std::move(created).value();
    out.write(text);
    return out.commit();
}

}  // namespace leitstand::detail
