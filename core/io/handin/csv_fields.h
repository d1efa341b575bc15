#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/io/detail/line_reader.h"

namespace leitstand {

/// @p text as a field in quotes (RFC 4180); line ends within become blanks, so that every record is a line. A
/// text that spreadsheets would calculate ("=HYPERLINK(...)" in a QR code) gets an apostrophe before it,
/// which CsvReader takes off again; numbers stay numbers.
[[nodiscard]] std::string quotedField(std::string_view text);
/// Likewise, with quotes only where they are needed.
[[nodiscard]] std::string csvField(std::string_view text);

/// Reads records of fields that commas part: quotes, CRLF, a byte order mark and blanks about fields are
/// taken as they come.
class CsvReader {
public:
    [[nodiscard]] static Result<CsvReader> open(const std::filesystem::path& file);

    /// The fields of the next line; false at the end and on a failure.
    bool next(std::vector<std::string>& fields);
    [[nodiscard]] const std::optional<Error>& failure() const { return m_lines.failure(); }
    /// "FILE:LINE: expected EXPECTATION, found "..."" of the last line.
    [[nodiscard]] Error mismatch(std::string_view expectation) const {
        return m_lines.mismatch(expectation, m_line);
    }

private:
    explicit CsvReader(detail::LineReader lines) : m_lines(std::move(lines)) {}
    detail::LineReader m_lines;
    std::string m_line;
};

}  // namespace leitstand
