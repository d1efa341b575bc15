#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/io/detail/input_file.h"

namespace leitstand::detail {

/// The bytes of a large file, of which a window is in memory. One thread.
class FileWindow {
public:
    /// Opens @p path. Error when it cannot be read.
    [[nodiscard]] static Result<FileWindow> open(const std::filesystem::path& path);

    /// Returns @p count bytes from byte @p offset, or fewer at the end of the file or where the disk fails.
    /// They stay valid until the next call.
    [[nodiscard]] std::span<const std::byte> at(std::uint64_t offset, std::uint64_t count);
    [[nodiscard]] std::uint64_t size() const { return m_file.size(); }  ///< [B]
    /// Looks how large the file is now, for one that is being written.
    void lookAgain();

private:
    explicit FileWindow(InputFile file) : m_file(std::move(file)) {}

    InputFile m_file;
    std::uint64_t m_begin = 0;        ///< of the window in the file [B]
    std::vector<std::byte> m_window;  ///< the bytes that were read last
};

}  // namespace leitstand::detail
