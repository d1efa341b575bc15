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

/// Hands out the lines of a text file, ended by LF or CRLF, and holds one chunk of it in memory.
class LineReader {
public:
    static constexpr std::size_t MaxLine = 65'536;  ///< longer lines are an error [bytes]

    [[nodiscard]] static Result<LineReader> open(const std::filesystem::path& path);
    /// Reads on from where @p file stands.
    explicit LineReader(InputFile file);

    /// The next line, valid until the next call; false at the end and on a failure.
    bool next(std::string_view& line);
    /// Why next() gave up before the end, if it did.
    [[nodiscard]] const std::optional<Error>& failure() const { return m_failure; }

    [[nodiscard]] std::size_t lineNumber() const { return m_lineNumber; }  ///< of the last line, from 1
    [[nodiscard]] std::uint64_t bytesTaken() const { return m_taken; }     ///< up to the end of that line
    [[nodiscard]] std::uint64_t fileSize() const { return m_file.size(); }

    /// "FILE:LINE: expected EXPECTATION, found "..."" for the last line.
    [[nodiscard]] Error mismatch(std::string_view expectation, std::string_view found) const;
    /// "FILE: expected EXPECTATION" for what the whole file lacks.
    [[nodiscard]] Error incomplete(std::string_view expectation) const;

private:
    bool refill();

    InputFile m_file;
    std::vector<char> m_buffer;
    std::size_t m_begin = 0, m_end = 0;  // what of the buffer is still to be handed out
    bool m_atEnd = false;
    std::size_t m_lineNumber = 0;
    std::uint64_t m_taken = 0;
    std::optional<Error> m_failure;
};

/// Number of line ends in a file, plus one for a last line without: an upper bound of the lines.
[[nodiscard]] Result<std::size_t> countLines(const std::filesystem::path& path);

/// @p text fit for a message: cut to 40 characters, what cannot be printed as "\xNN".
[[nodiscard]] std::string quotable(std::string_view text);

}  // namespace leitstand::detail
