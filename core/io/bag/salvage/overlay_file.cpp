#include "core/io/bag/salvage/overlay_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

namespace leitstand::detail {

OverlayFile::OverlayFile(const std::filesystem::path& file)
    : m_descriptor(::open(file.c_str(), O_RDONLY | O_CLOEXEC)) {
    struct stat status {};
    if (m_descriptor < 0 || ::fstat(m_descriptor, &status) != 0 || !S_ISREG(status.st_mode)) return;
    m_exists = true;
    m_baseSize = m_size = status.st_size;
}

OverlayFile::~OverlayFile() {
    if (m_descriptor >= 0) ::close(m_descriptor);
}

bool OverlayFile::readBase(std::int64_t offset, std::span<std::byte> into) const {
    std::size_t done = 0;
    const std::int64_t there = std::clamp<std::int64_t>(m_baseSize - offset, 0, std::ssize(into));
    while (done < static_cast<std::size_t>(there)) {
        const ssize_t got = ::pread(m_descriptor, into.data() + done, static_cast<std::size_t>(there) - done,
                                    offset + static_cast<std::int64_t>(done));
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return false;
        if (got == 0) break;  // someone truncated it meanwhile
        done += static_cast<std::size_t>(got);
    }
    std::fill(into.begin() + static_cast<std::ptrdiff_t>(done), into.end(), std::byte{0});
    return true;
}

bool OverlayFile::read(std::int64_t offset, std::span<std::byte> into) const {
    if (!readBase(offset, into)) return false;
    const std::int64_t end = offset + std::ssize(into);
    for (auto block = m_blocks.lower_bound(offset / BlockSize);
         block != m_blocks.end() && block->first * BlockSize < end; ++block) {
        const std::int64_t begins = block->first * BlockSize;
        const std::int64_t from = std::max(offset, begins), to = std::min(end, begins + BlockSize);
        std::copy(block->second.begin() + (from - begins), block->second.begin() + (to - begins),
                  into.begin() + (from - offset));
    }
    return true;
}

void OverlayFile::write(std::int64_t offset, std::span<const std::byte> bytes) {
    m_exists = true;
    const std::int64_t end = offset + std::ssize(bytes);
    for (std::int64_t number = offset / BlockSize; number * BlockSize < end; ++number) {
        const std::int64_t begins = number * BlockSize;
        auto [block, fresh] = m_blocks.try_emplace(number);
        if (fresh) {
            block->second.resize(static_cast<std::size_t>(BlockSize));
            (void)readBase(begins, block->second);
        }
        const std::int64_t from = std::max(offset, begins), to = std::min(end, begins + BlockSize);
        std::copy(bytes.begin() + (from - offset), bytes.begin() + (to - offset),
                  block->second.begin() + (from - begins));
    }
    m_size = std::max(m_size, end);
}

void OverlayFile::resize(std::int64_t size) {
    if (size < m_size) {
        m_baseSize = std::min(m_baseSize, size);
        m_blocks.erase(m_blocks.lower_bound((size + BlockSize - 1) / BlockSize), m_blocks.end());
        const auto cut = m_blocks.find(size / BlockSize);
        if (cut != m_blocks.end()) {
            std::fill(cut->second.begin() + size % BlockSize, cut->second.end(), std::byte{0});
        }
    }
    m_size = size;
}

void OverlayFile::remove() {
    resize(0);
    m_exists = false;
}

}  // namespace leitstand::detail
