#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/io/detail/line_reader.h"

namespace leitstand {

/// Returns @p text as a field in quotes (RFC 4180). Line ends within it become blanks, so that each record is
/// one line. If a spreadsheet would evaluate the text ("=HYPERLINK(...)" in a QR code), an apostrophe is put
/// in front. CsvReader removes it again. Numbers are left as they are.
[[nodiscard]] std::string quotedField(std::string_view text);
/// Returns the same as quotedField(), but with quotes only when needed.
[[nodiscard]] std::string csvField(std::string_view text);

/// Reads records of comma-separated fields. Accepts quotes, CRLF, a byte order mark and blanks around fields.
class CsvReader {
public:
    [[nodiscard]] static Result<CsvReader> open(const std::filesystem::path& file);

    /// Reads the fields of the next line into @p fields. False at the end of the file and on a failure.
    bool next(std::vector<std::string>& fields);
    [[nodiscard]] const std::optional<Error>& failure() const { return m_lines.failure(); }
    /// Returns "FILE:LINE: expected EXPECTATION, found "..."" for the last line.
    [[nodiscard]] Error mismatch(std::string_view expectation) const {
        return m_lines.mismatch(expectation, m_line);
    }

private:
    explicit CsvReader(detail::LineReader lines) : m_lines(std::move(lines)) {}
    detail::LineReader m_lines;
    std::string m_line;
};

}  // namespace leitstand
