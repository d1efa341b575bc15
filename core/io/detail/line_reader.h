#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/io/detail/input_file.h"

namespace leitstand::detail {

/// Reads the lines of a text file, which end in LF or CRLF. Holds only one chunk of the file in memory.
class LineReader {
public:
    static constexpr std::size_t MaxLine = 65'536;  ///< longer lines are an error [B]

    [[nodiscard]] static Result<LineReader> open(const std::filesystem::path& path);
    /// Reads from the current position of @p file on.
    explicit LineReader(InputFile file);

    /// Sets @p line to the next line, which stays valid until the next call. False at the end of the file and
    /// on a failure.
    bool next(std::string_view& line);
    /// Why next() stopped before the end of the file; empty when it did not.
    [[nodiscard]] const std::optional<Error>& failure() const { return m_failure; }

    /// Number of the last line, counted from 1.
    [[nodiscard]] std::size_t lineNumber() const { return m_lineNumber; }
    /// Bytes of the file up to the end of that line.
    [[nodiscard]] std::uint64_t bytesTaken() const { return m_taken; }
    [[nodiscard]] std::uint64_t fileSize() const { return m_file.size(); }

    /// Returns "FILE:LINE: expected EXPECTATION, found "..."" for the last line.
    [[nodiscard]] Error mismatch(std::string_view expectation, std::string_view found) const;
    /// Returns "FILE: expected EXPECTATION", for something that is missing in the whole file.
    [[nodiscard]] Error incomplete(std::string_view expectation) const;

private:
    bool refill();

    InputFile m_file;
    std::vector<char> m_buffer;
    std::size_t m_begin = 0, m_end = 0;  // the part of the buffer still to be read
    bool m_atEnd = false;
    std::size_t m_lineNumber = 0;
    std::uint64_t m_taken = 0;
    std::optional<Error> m_failure;
};

/// Returns an upper bound for the number of lines in a file: its line ends plus one, since the last line may
/// lack an end.
[[nodiscard]] Result<std::size_t> countLines(const std::filesystem::path& path);

/// Returns @p text for use in a message: cut to 40 characters, unprintable bytes as "\xNN".
[[nodiscard]] std::string quotable(std::string_view text);

}  // namespace leitstand::detail
