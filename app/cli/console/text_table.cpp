#include "app/cli/console/text_table.h"

#include <algorithm>
#include <cctype>

#include "core/base/printable.h"

namespace leitstand::cli {
namespace {

std::size_t characters(const std::string& text) {
    return static_cast<std::size_t>(
        std::count_if(text.begin(), text.end(), [](char byte) { return (byte & '\xC0') != '\x80'; }));
}

bool isNumber(const std::string& text) {
    return !text.empty() &&
           (std::isdigit(static_cast<unsigned char>(text.front())) != 0 || text.front() == '-');
}

/// Whether column @p i of the body holds numbers only, or nothing.
bool isNumeric(const std::vector<std::vector<std::string>>& rows, std::size_t i) {
    return std::all_of(rows.begin() + 1, rows.end(), [i](const std::vector<std::string>& row) {
        return i >= row.size() || row[i].empty() || isNumber(row[i]);
    });
}

}  // namespace

std::string textTable(const std::vector<std::vector<std::string>>& given) {
    auto rows = given;
    for (auto& row : rows) {
        for (std::string& cell : row) cell = printable(cell);
    }
    std::vector<std::size_t> widths;
    for (const auto& row : rows) {
        widths.resize(std::max(widths.size(), row.size()), 0);
        for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], characters(row[i]));
    }
    std::vector<bool> numeric;
    for (std::size_t i = 0; i < widths.size(); ++i) numeric.push_back(isNumeric(rows, i));
    std::string text;
    for (const auto& row : rows) {
        std::string line;
        for (std::size_t i = 0; i < row.size(); ++i) {
            const std::string padding(widths[i] - characters(row[i]), ' ');
            if (i > 0) line += "  ";
            line += numeric[i] ? padding + row[i] : row[i] + padding;
        }
        line.erase(line.find_last_not_of(' ') + 1);
        text += line + '\n';
    }
    return text;
}

}  // namespace leitstand::cli
