#include "core/io/handin/csv_fields.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/io/detail/numbers.h"

namespace leitstand {
namespace {

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\t' || text.back() == '\r'))
        text.remove_suffix(1);
    return text;
}

/// Whether spreadsheets treat @p text as a formula. Numbers are none, whatever their sign.
bool isFormula(std::string_view text) {
    if (text.starts_with('\t') || text.starts_with('\r') || text.starts_with('\n')) return true;
    const auto first = text.find_first_not_of(" \t\r\n\v\f");
    if (first == std::string_view::npos) return false;
    const auto number = detail::toNumber(text);
    if (number && std::isfinite(*number)) return false;
    const std::string_view begin = text.substr(first);
    // Japanese keyboards write the last four in place of the others.
    constexpr std::array<std::string_view, 8> Signs = {"=", "+", "-", "@", "＝", "＋", "－", "＠"};
    return std::any_of(Signs.begin(), Signs.end(),
                       [&](std::string_view sign) { return begin.starts_with(sign); });
}

/// Whether @p text is a formula, also after apostrophes, which must stay distinct from ours.
bool isKept(std::string_view text) {
    const auto first = text.find_first_not_of('\'');
    return first != std::string_view::npos && isFormula(text.substr(first));
}

/// Removes the next field and the comma after it from @p rest; the last field sets @p more to false.
std::string takeField(std::string_view& rest, bool& more) {
    while (!rest.empty() && (rest.front() == ' ' || rest.front() == '\t')) rest.remove_prefix(1);
    std::string field;
    if (rest.starts_with('"')) {
        rest.remove_prefix(1);
        while (!rest.empty()) {
            if (rest.front() == '"') {
                if (!rest.starts_with("\"\"")) break;
                rest.remove_prefix(1);
            }
            field += rest.front();
            rest.remove_prefix(1);
        }
        if (!rest.empty()) rest.remove_prefix(1);  // the closing quote
    }
    const auto comma = rest.find(',');
    field += trimmed(rest.substr(0, comma));
    more = comma != std::string_view::npos;
    rest.remove_prefix(more ? comma + 1 : rest.size());
    if (field.starts_with('\'') && isKept(field)) field.erase(0, 1);
    return field;
}

/// Returns @p text as it stands in a field. A text that a spreadsheet would treat as a formula gets an
/// apostrophe in front, which marks it as text.
std::string kept(std::string_view text) {
    return (isKept(text) ? "'" : "") + std::string(text);
}

}  // namespace

std::string quotedField(std::string_view text) {
    std::string field = "\"";
    for (const char letter : kept(text)) {
        if (letter == '"') field += '"';
        field += letter == '\n' || letter == '\r' ? ' ' : letter;
    }
    return field + "\"";
}

std::string csvField(std::string_view text) {
    const bool blank = !text.empty() && (text.front() == ' ' || text.back() == ' ');
    if (!blank && text.find_first_of("\",\r\n") == std::string_view::npos) return kept(text);
    return quotedField(text);
}

Result<CsvReader> CsvReader::open(const std::filesystem::path& file) {
    auto opened = detail::LineReader::open(file);
    if (!opened) return opened.error();
    return CsvReader(std::move(opened).value());
}

bool CsvReader::next(std::vector<std::string>& fields) {
    std::string_view line;
    if (!m_lines.next(line)) return false;
    if (m_lines.lineNumber() == 1 && line.starts_with("\xEF\xBB\xBF")) line.remove_prefix(3);
    m_line = line;
    fields.clear();
    std::string_view rest = m_line;
    for (bool more = true; more;) fields.push_back(takeField(rest, more));
    return true;
}

}  // namespace leitstand
