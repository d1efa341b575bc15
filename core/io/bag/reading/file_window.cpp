#include "core/io/bag/reading/file_window.h"

#include <algorithm>

namespace leitstand::detail {
namespace {

constexpr std::uint64_t Ahead = 64U << 10U;  ///< is read at once, where records are small [B]

}  // namespace

Result<FileWindow> FileWindow::open(const std::filesystem::path& path) {
    auto file = InputFile::open(path);
    if (!file) return file.error();
    return FileWindow(std::move(file).value());
}

void FileWindow::lookAgain() {
    m_file.lookAgain();
    m_window.clear();
}

std::span<const std::byte> FileWindow::at(std::uint64_t offset, std::uint64_t count) {
    if (offset >= m_file.size()) return {};
    count = std::min(count, m_file.size() - offset);
    const bool here = offset >= m_begin && offset + count <= m_begin + m_window.size();
    if (!here) {
        const std::uint64_t wanted = std::min(std::max(count, Ahead), m_file.size() - offset);
        m_window.resize(static_cast<std::size_t>(wanted));
        m_begin = offset;
        std::size_t got = 0;
        if (m_file.seek(offset)) {
            const auto read = m_file.read(reinterpret_cast<char*>(m_window.data()), m_window.size());
            got = read ? *read : 0;
        }
        m_window.resize(got);
    }
    const auto from = static_cast<std::size_t>(offset - m_begin);
    if (from >= m_window.size()) return {};
    return std::span(std::as_const(m_window))
        .subspan(from, std::min<std::size_t>(static_cast<std::size_t>(count), m_window.size() - from));
}

}  // namespace leitstand::detail
