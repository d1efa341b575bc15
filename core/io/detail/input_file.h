#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "core/base/result.h"

namespace leitstand::detail {

/// A regular file that is open for reading. It is not buffered.
class InputFile {
public:
    /// Opens @p path. Error when it is missing, a directory or not readable.
    [[nodiscard]] static Result<InputFile> open(const std::filesystem::path& path);

    /// Reads up to @p count bytes; fewer only at the end of the file.
    [[nodiscard]] Result<std::size_t> read(char* to, std::size_t count);
    /// Goes to byte @p offset.
    [[nodiscard]] Result<void> seek(std::uint64_t offset);

    [[nodiscard]] const std::filesystem::path& path() const { return m_path; }
    /// Size when it was opened, or when somebody looked again [B].
    [[nodiscard]] std::uint64_t size() const { return m_size; }
    /// Looks how large the file is now.
    void lookAgain();

private:
    struct Close {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    std::filesystem::path m_path;
    std::unique_ptr<std::FILE, Close> m_file;
    std::uint64_t m_size = 0;
};

}  // namespace leitstand::detail
