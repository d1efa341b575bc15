#include "core/io/page_file.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <iterator>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

namespace leitstand {
namespace {

constexpr std::uint64_t Block = 4096;  ///< [bytes]

std::uint64_t blocksOf(std::size_t bytes) {
    return (bytes + Block - 1) / Block;
}

/// Opens a file without a name in @p folder; negative when that fails.
int unnamedFile(const std::filesystem::path& folder) {
    const int file = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, S_IRUSR | S_IWUSR);
    if (file >= 0) return file;
    std::string name = (folder / ".pages-XXXXXX").string();  // for file systems without unnamed files
    const int named = ::mkostemp(name.data(), O_CLOEXEC);
    if (named >= 0) ::unlink(name.c_str());
    return named;
}

/// Calls @p transfer (done so far) until all of @p bytes are done; false when it cannot go on.
template <typename Transfer>
bool all(std::size_t bytes, Transfer transfer) {
    for (std::size_t done = 0; done < bytes;) {
        const ssize_t now = transfer(done);
        if (now < 0 && errno == EINTR) continue;
        if (now <= 0) return false;
        done += static_cast<std::size_t>(now);
    }
    return true;
}

}  // namespace

Result<std::shared_ptr<PageFile>> PageFile::open(const std::filesystem::path& folder) {
    const int file = unnamedFile(folder);
    if (file < 0)
        return Error{folder.string() +
                     ": no file can be made there: " + std::generic_category().message(errno)};
    return std::shared_ptr<PageFile>(new PageFile(file));
}

PageFile::~PageFile() {
    ::close(m_file);
}

std::uint64_t PageFile::place(std::uint64_t blocks) {
    auto best = m_free.end();
    for (auto one = m_free.begin(); one != m_free.end(); ++one) {
        if (one->second >= blocks && (best == m_free.end() || one->second < best->second)) best = one;
    }
    if (best == m_free.end()) {
        m_end += blocks;
        return m_end - blocks;
    }
    const auto [first, free] = *best;
    m_free.erase(best);
    if (free > blocks) m_free.emplace(first + blocks, free - blocks);
    return first;
}

std::optional<std::uint64_t> PageFile::put(std::span<const std::byte> bytes) {
    std::uint64_t page = 0;
    {
        const std::lock_guard lock(m_mutex);
        page = place(blocksOf(bytes.size()));
    }
    const bool written = all(bytes.size(), [&](std::size_t done) {
        return ::pwrite(m_file, bytes.data() + done, bytes.size() - done,
                        static_cast<off_t>(page * Block + done));
    });
    if (written) return page;
    release(page, bytes.size());
    return std::nullopt;
}

bool PageFile::read(std::uint64_t page, std::span<std::byte> into) const {
    return all(into.size(), [&](std::size_t done) {
        return ::pread(m_file, into.data() + done, into.size() - done,
                       static_cast<off_t>(page * Block + done));
    });
}

void PageFile::release(std::uint64_t page, std::size_t bytes) {
    const std::lock_guard lock(m_mutex);
    const auto one = m_free.emplace(page, blocksOf(bytes)).first;
    const auto next = std::next(one);
    if (next != m_free.end() && one->first + one->second == next->first) {
        one->second += next->second;
        m_free.erase(next);
    }
    if (one == m_free.begin()) return;
    const auto before = std::prev(one);
    if (before->first + before->second != one->first) return;
    before->second += one->second;
    m_free.erase(one);
}

std::uint64_t PageFile::size() const {
    const std::lock_guard lock(m_mutex);
    return m_end * Block;
}

}  // namespace leitstand
