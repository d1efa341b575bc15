#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace leitstand::detail {

/// A file that is written completely or not at all. It is written under a temporary name beside its target,
/// and renamed at the end.
class OutputFile {
public:
    /// Creates the temporary file. Error when the folder is absent or not writable.
    [[nodiscard]] static Result<OutputFile> create(const std::filesystem::path& target);
    OutputFile(OutputFile&&) noexcept = default;
    OutputFile& operator=(OutputFile&&) = delete;
    ~OutputFile();

    /// Appends @p bytes. Failures are reported by commit(), which returns the first one.
    void write(std::string_view bytes);
    /// Writes everything to the disk and replaces the target.
    [[nodiscard]] Result<void> commit();

private:
    struct Close {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    OutputFile() = default;
    [[nodiscard]] Error problem(int number) const;

    std::filesystem::path m_target, m_temporary;
    std::unique_ptr<std::FILE, Close> m_file;
    int m_failed = 0;  // errno of the first failure
};

/// Writes @p text to @p target, completely or not at all.
[[nodiscard]] Result<void> writeWhole(const std::filesystem::path& target, std::string_view text);

}  // namespace leitstand::detail
